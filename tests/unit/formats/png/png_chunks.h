// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <doctest/doctest.h>
#include <zlib.h>

#include <cstdint>
#include <string>
#include <vector>

#include "unit/formats/files/inflated.h"

/// A PNG file taken apart by its standard (ISO/IEC 15948); the check sums of its chunks are checked.
struct PngChunks {
  struct Chunk {
    std::string type, content;
  };
  std::vector<Chunk> all;
  std::string names;  ///< of the chunks, one behind the other, those of the pixels once

  explicit PngChunks(const std::string& png) {
    CHECK(png.substr(0, 8) == "\x89PNG\r\n\x1a\n");
    for (size_t at = 8; at < png.size();) {
      const uint32_t length = number(png, at);
      REQUIRE(at + 12 + length <= png.size());
      const Chunk chunk{png.substr(at + 4, 4), png.substr(at + 8, length)};
      const auto* body = reinterpret_cast<const Bytef*>(png.data() + at + 4);
      CHECK(number(png, at + 8 + length) == crc32(0, body, length + 4));
      if (chunk.type != "IDAT" || !names.ends_with("IDAT")) names += chunk.type;
      all.push_back(chunk);
      at += 12 + length;
    }
  }

  static uint32_t number(const std::string& bytes, size_t at) {
    uint32_t out = 0;
    for (const char c : bytes.substr(at, 4)) out = out << 8 | static_cast<unsigned char>(c);
    return out;
  }
  std::string content(const char* type) const {
    std::string out;
    for (const Chunk& chunk : all)
      if (chunk.type == type) out += chunk.content;
    return out;
  }
  uint32_t width() const { return number(content("IHDR"), 0); }
  uint32_t height() const { return number(content("IHDR"), 4); }

  /// The bytes of all rows; filters none and "sub" are undone, by pixels of so many bytes.
  std::string pixels(size_t pixel_bytes) const {
    const Inflated rows(content("IDAT"));
    CHECK(rows.ok);
    const size_t bytes = pixel_bytes * width();
    REQUIRE(rows.text.size() == (bytes + 1) * height());
    std::string out;
    for (size_t y = 0; y < height(); ++y) {
      std::string row = rows.text.substr(y * (bytes + 1), bytes + 1);
      REQUIRE(row[0] <= 1);
      for (size_t i = pixel_bytes + 1; row[0] == 1 && i < row.size(); ++i)
        row[i] = static_cast<char>(row[i] + row[i - pixel_bytes]);
      out += row.substr(1);
    }
    return out;
  }
};
