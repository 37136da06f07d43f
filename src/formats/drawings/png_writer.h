// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/task.h"

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

/// The picture as a PNG file (ISO/IEC 15948, colour type 3). Even areas shrink to little; nothing takes more than 9
/// bits a pixel.
std::string png_of(const IndexedImage& image);

/// A picture in true colour: red, green, blue and opacity of each pixel, row by row from the top.
struct RgbaImage {
  uint32_t width = 0, height = 0;
  std::vector<uint8_t> pixels;
};

/// Colour type 6; each byte less that of the pixel before it, which natural pictures shrink by.
std::string png_of(const RgbaImage& image, Task& task);

/// Text form of bytes for data: addresses (RFC 4648).
std::string base64_of(std::string_view bytes);

}  // namespace jalon
