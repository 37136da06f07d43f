// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// Chunks of pictures against sums that are worked out bit by bit here; that pixels come back: png_test.cpp.
#include "formats/drawings/png_writer.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "base/random.h"

using namespace jalon;

namespace {

uint32_t number_at(const std::string& bytes, size_t at) {
  uint32_t out = 0;
  for (const char c : bytes.substr(at, 4)) out = out << 8 | static_cast<unsigned char>(c);
  return out;
}

/// The division of ISO 3309, a bit at a time.
uint32_t remainder_of(std::string_view bytes) {
  uint32_t rest = 0xffffffff;
  for (const char c : bytes)
    for (uint32_t bit = 0; bit < 8; ++bit) {
      const bool odd = ((rest ^ (static_cast<unsigned char>(c) >> bit)) & 1) != 0;
      rest = rest >> 1 ^ (odd ? 0xedb88320 : 0);
    }
  return ~rest;
}

struct Chunk {
  std::string type, content;
};
/// To the end of the file; each sum is checked.
std::vector<Chunk> chunks_of(const std::string& png) {
  std::vector<Chunk> out;
  for (size_t at = 8; at < png.size();) {
    const uint32_t length = number_at(png, at);
    REQUIRE(at + 12 + length <= png.size());
    out.push_back({png.substr(at + 4, 4), png.substr(at + 8, length)});
    CHECK(number_at(png, at + 8 + length) == remainder_of(png.substr(at + 4, 4 + length)));
    at += 12 + length;
  }
  return out;
}

IndexedImage random_image(uint32_t width, uint32_t height, size_t colours) {
  RandomStream random(width, height);
  IndexedImage image{width, height, {}, {}};
  for (size_t i = 0; i < size_t{width} * height; ++i)
    image.pixels.push_back(static_cast<uint8_t>(random.below(colours)));
  for (size_t i = 0; i < colours; ++i)
    image.palette.push_back({static_cast<uint8_t>(i), static_cast<uint8_t>(random.below(256)), 7});
  return image;
}

}  // namespace

TEST_CASE("png_writer__chunks_fill_the_file_in_the_order_of_the_standard_with_their_sums") {
  REQUIRE(remainder_of("123456789") == 0xcbf43926);  // the check value of CRC-32
  for (const auto& [width, height] :
       {std::pair(1u, 1u), std::pair(300u, 5u), std::pair(2u, 1000u)}) {
    const IndexedImage image = random_image(width, height, 256);
    const std::vector<Chunk> chunks = chunks_of(png_of(image));
    REQUIRE(chunks.size() == 4);
    CHECK(chunks[0].type + chunks[1].type + chunks[2].type + chunks[3].type == "IHDRPLTEIDATIEND");
    CHECK(number_at(chunks[0].content, 0) == width);
    CHECK(number_at(chunks[0].content, 4) == height);
    CHECK(chunks[0].content.substr(8) == std::string("\x08\x03\0\0\0", 5));
    REQUIRE(chunks[1].content.size() == 768);
    for (size_t i = 0; i < 256; ++i) {
      const Rgb& colour = image.palette[i];
      const std::string entry = chunks[1].content.substr(3 * i, 3);
      CHECK(Rgb{static_cast<uint8_t>(entry[0]), static_cast<uint8_t>(entry[1]),
                static_cast<uint8_t>(entry[2])} == colour);
    }
    CHECK(chunks[3].content.empty());
    // At most 9 bits a pixel and a filter byte a row, the frame of the stream and its chunk aside.
    CHECK(chunks[2].content.size() <= (size_t{width} + 1) * height * 9 / 8 + 9);
  }
}

TEST_CASE("png_writer__a_description_stands_before_the_pixels_and_changes_nothing_else") {
  IndexedImage image = random_image(7, 5, 3);
  std::vector<Chunk> without = chunks_of(png_of(image));
  image.description = "distances, blue to red";
  std::vector<Chunk> with = chunks_of(png_of(image));
  REQUIRE(with.size() == without.size() + 1);
  CHECK(with[2].type == "tEXt");
  CHECK(with[2].content == std::string("Description") + '\0' + image.description);
  with.erase(with.begin() + 2);
  for (size_t i = 0; i < with.size(); ++i) {
    CHECK(with[i].type == without[i].type);
    CHECK(with[i].content == without[i].content);
  }
}

TEST_CASE("png_writer__base64_leads_back_to_any_bytes_and_hex_to_any_colour") {
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  RandomStream random(1, 1);
  for (size_t n = 0; n < 80; ++n) {
    std::string bytes, bits, back;
    for (size_t i = 0; i < n; ++i) bytes += static_cast<char>(random.below(256));
    const std::string text = base64_of(bytes);
    REQUIRE(text.size() == (n + 2) / 3 * 4);
    const size_t padding = text.size() - std::min(text.size(), text.find('='));
    CHECK(padding == (3 - n % 3) % 3);
    for (const char c : text.substr(0, text.size() - padding)) {
      const size_t value = digits.find(c);
      REQUIRE(value < 64);
      for (int bit = 5; bit >= 0; --bit) bits += (value >> bit & 1) != 0 ? '1' : '0';
    }
    for (size_t at = 0; at + 8 <= bits.size(); at += 8)
      back += static_cast<char>(std::stoi(bits.substr(at, 8), nullptr, 2));
    CHECK(back == bytes);
  }
  for (int i = 0; i < 100; ++i) {
    const auto colour = static_cast<uint32_t>(random.below(1u << 24));
    const auto part = [&](uint32_t shift) { return static_cast<uint8_t>(colour >> shift & 255); };
    const std::string text = hex_of({part(16), part(8), part(0)});
    REQUIRE(text.size() == 7);
    CHECK(text[0] == '#');
    CHECK(std::stoul(text.substr(1), nullptr, 16) == colour);
  }
}

TEST_CASE("png__true_colour_is_told_by_the_differences_along_each_row") {
  const RgbaImage image{2, 2, {10, 20, 30, 255, 11, 18, 30, 255, 0, 0, 0, 0, 250, 1, 2, 255}};
  Task task;
  const std::string png = png_of(image, task);
  CHECK(png.substr(0, 8) == "\x89PNG\r\n\x1a\n");
  CHECK(png.substr(16, 10) == std::string("\0\0\0\2\0\0\0\2\x08\x06", 10));
  const size_t data = png.find("IDAT") + 4, length = png.find("IEND") - 8 - data;
  const Inflated rows(std::string_view(png).substr(data, length));
  CHECK(rows.ok);
  CHECK(rows.text == std::string("\1\x0a\x14\x1e\xff\x01\xfe\0\0\1\0\0\0\0\xfa\x01\x02\xff", 18));
}
