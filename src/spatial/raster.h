// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/vec.h"

namespace jalon {

/// Binary image on a plane: pixel (column, row) covers origin + [column, column + 1) x [row, row +
/// 1) times pixel_m. One byte a pixel, row by row, 0 = empty.
struct Raster {
  Vec2 origin;
  double pixel_m = 1;
  uint32_t columns = 0, rows = 0;
  std::vector<uint8_t> pixels;

  size_t size() const { return pixels.size(); }
  /// The pixel of a point; points outside the image go to the nearest pixel. The image must not be empty.
  size_t pixel_of(const Vec2& p) const;
  /// Whether a point lies in an occupied pixel; nowhere outside the image.
  bool holds(const Vec2& p) const;
  Vec2 centre(size_t pixel) const {
    return {origin.u + (static_cast<double>(pixel % columns) + 0.5) * pixel_m,
            origin.v + (static_cast<double>(pixel / columns) + 0.5) * pixel_m};
  }
};

/// Most pixels that rasterise() makes; a longer image is Error(kLimit).
constexpr uint64_t kMaxRasterPixels = uint64_t{1} << 28;

/// The occupied pixels of the points (Boulaassal 2010, 3.4.6 step 2). The origin is the smallest
/// (u, v) minus margin pixels, so the image depends on the points' relative positions only; margin
/// pixels stay empty on every side. No points: an empty raster.
Raster rasterise(std::span<const Vec2> points, double pixel_m, uint32_t margin = 0);

/// Which pixels count as neighbours.
enum class Connectivity2 { k4, k8 };

/// Connected regions of the occupied pixels, numbered 1, 2 ... by falling size, ties by first
/// pixel; label 0 = empty.
struct Regions {
  std::vector<uint32_t> labels;        ///< one a pixel
  std::vector<uint64_t> pixel_counts;  ///< [0] = empty pixels, [label] = pixels of that region
  size_t count() const { return pixel_counts.empty() ? 0 : pixel_counts.size() - 1; }
};
/// Two passes with union-find (Rosenfeld & Pfaltz 1966). O(pixels).
Regions label_regions(const Raster& raster, Connectivity2 connectivity = Connectivity2::k8);

/// Morphology with a square of (2 radius + 1) pixels. Beyond the border everything is empty: for
/// dilated() and closed() give the raster a margin of radius.
Raster dilated(const Raster& raster, uint32_t radius);
Raster eroded(const Raster& raster, uint32_t radius);
inline Raster closed(const Raster& raster, uint32_t radius) {
  return eroded(dilated(raster, radius), radius);
}
inline Raster opened(const Raster& raster, uint32_t radius) {
  return dilated(eroded(raster, radius), radius);
}

}  // namespace jalon
