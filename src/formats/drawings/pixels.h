// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace jalon {

struct Rgb {
  uint8_t red = 0, green = 0, blue = 0;
  bool operator==(const Rgb&) const = default;
};

/// "#rrggbb".
std::string hex_of(const Rgb& colour);

/// A picture of at most 256 colours: one palette index a pixel, row by row from the top.
struct IndexedImage {
  uint32_t width = 0, height = 0;
  std::vector<uint8_t> pixels;
  std::vector<Rgb> palette;
  std::string description = {};  ///< Latin text of the file's chunk "Description"; "": none
};

/// A picture in true colour: red, green, blue and opacity of each pixel, row by row from the top.
struct RgbaImage {
  uint32_t width = 0, height = 0;
  std::vector<uint8_t> pixels;
};

/// Text form of bytes for data: addresses (RFC 4648).
std::string base64_of(std::string_view bytes);

}  // namespace jalon
