// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/drawings/png_writer.h"

#include "base/crc32.h"
#include "formats/files/deflate.h"
#include "formats/files/deflate_blocks.h"

namespace jalon {

namespace {

std::string big_endian(uint32_t value) {
  std::string out;
  for (int shift = 24; shift >= 0; shift -= 8) out += static_cast<char>(value >> shift & 0xff);
  return out;
}

void add_chunk(std::string& out, std::string_view type, std::string_view content) {
  const std::string body = std::string(type).append(content);
  out += big_endian(static_cast<uint32_t>(content.size()));
  out += body;
  out += big_endian(crc32(0, body.data(), body.size()));
}

// Signature and header of a picture of 8 bits a sample.
std::string beginning(uint32_t width, uint32_t height, char colour_type) {
  constexpr char kBitDepth = 8;
  std::string header = big_endian(width) + big_endian(height);
  header += {kBitDepth, colour_type, 0, 0, 0};
  std::string out = "\x89PNG\r\n\x1a\n";
  add_chunk(out, "IHDR", header);
  return out;
}

}  // namespace

std::string hex_of(const Rgb& colour) {
  constexpr const char* kDigits = "0123456789abcdef";
  std::string out = "#";
  for (const uint8_t part : {colour.red, colour.green, colour.blue}) {
    out += kDigits[part >> 4];
    out += kDigits[part & 15];
  }
  return out;
}

std::string png_of(const IndexedImage& image) {
  constexpr char kPaletteColour = 3, kFilterNone = 0;
  std::string palette;
  for (const Rgb& c : image.palette)
    palette += {static_cast<char>(c.red), static_cast<char>(c.green), static_cast<char>(c.blue)};
  std::string rows;
  rows.reserve((image.width + size_t{1}) * image.height);
  for (uint32_t y = 0; y < image.height; ++y) {
    rows += kFilterNone;
    rows.append(reinterpret_cast<const char*>(image.pixels.data()) + size_t{y} * image.width,
                image.width);
  }
  std::string out = beginning(image.width, image.height, kPaletteColour);
  add_chunk(out, "PLTE", palette);
  if (!image.description.empty())
    add_chunk(out, "tEXt", std::string("Description\0", 12) + image.description);
  add_chunk(out, "IDAT", zlib_of(rows, image.width + size_t{1}));
  add_chunk(out, "IEND", {});
  return out;
}

std::string png_of(const RgbaImage& image, Task& task) {
  constexpr char kTrueColourWithAlpha = 6, kFilterSub = 1;
  constexpr size_t kSamples = 4;
  const size_t row_bytes = kSamples * image.width;
  std::string rows;
  rows.reserve((row_bytes + 1) * image.height);
  for (size_t y = 0; y < image.height; ++y) {
    rows += kFilterSub;
    const uint8_t* row = image.pixels.data() + y * row_bytes;
    for (size_t i = 0; i < row_bytes; ++i)
      rows += static_cast<char>(row[i] - (i >= kSamples ? row[i - kSamples] : 0));
  }
  std::string out = beginning(image.width, image.height, kTrueColourWithAlpha);
  add_chunk(out, "IDAT", zlib_blocks(rows, task));
  add_chunk(out, "IEND", {});
  return out;
}

std::string base64_of(std::string_view bytes) {
  constexpr const char* kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  out.reserve((bytes.size() + 2) / 3 * 4);
  for (size_t i = 0; i < bytes.size(); i += 3) {
    const auto byte = [&](size_t k) {
      return i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u;
    };
    const uint32_t three = byte(0) << 16 | byte(1) << 8 | byte(2);
    out += kDigits[three >> 18];
    out += kDigits[three >> 12 & 63];
    out += i + 1 < bytes.size() ? kDigits[three >> 6 & 63] : '=';
    out += i + 2 < bytes.size() ? kDigits[three & 63] : '=';
  }
  return out;
}

}  // namespace jalon
