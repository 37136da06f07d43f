// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "base/field.h"
#include "cloud/cloud.h"
#include "unit/formats/png/png_chunks.h"

/// What pictures hold, and clouds to draw.
namespace picture_pixels {

using namespace jalon;

/// Whether a PNG file holds these palette indices, row by row from the top.
inline bool has_pixels(const std::string& png, size_t columns, std::span<const uint8_t> pixels) {
  const PngChunks chunks(png);
  return chunks.width() == columns && chunks.pixels(1) == std::string(pixels.begin(), pixels.end());
}

/// Bytes of the palette's entry, red, green, blue.
inline std::vector<int> palette_entry(const std::string& png, size_t entry) {
  const size_t at = png.find("PLTE") + 4 + 3 * entry;
  std::vector<int> out;
  for (size_t k = 0; k < 3; ++k) out.push_back(static_cast<unsigned char>(png.at(at + k)));
  return out;
}

inline Cloud cloud_of_points(const std::vector<Vec3>& points) {
  Buffer<double> xyz(3 * points.size());
  for (size_t i = 0; i < points.size(); ++i)
    for (int k = 0; k < 3; ++k) xyz[3 * i + static_cast<size_t>(k)] = points[i][k];
  return make_cloud(std::move(xyz));
}

}  // namespace picture_pixels
