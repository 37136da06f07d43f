// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "segment/raster/depth_image.h"

namespace jalon {

/// Where the points of an image lie along its axes u, v and n.
struct ImageBox {
  std::array<double, 3> low{INFINITY, INFINITY, INFINITY}, high{-INFINITY, -INFINITY, -INFINITY};
  size_t points = 0;

  void add(const std::array<double, 3>& at);
  ImageBox& operator+=(const ImageBox& b);
  /// Columns, or rows for axis 1, of so wide pixels.
  double cells(size_t axis, double pixel_m) const {
    return std::floor((high[axis] - low[axis]) / pixel_m) + 1;
  }
};

/// That of the candidates that are free.
ImageBox free_points_box(const SegmentScene& scene, std::span<const uint32_t> candidates,
                         const ImageAxes& axes, Task& task);

/// Pixels that an image of a cloud of so many points may have.
double most_image_pixels(size_t points);

/// The free candidates that lie far from most of them, where one image of all would need wider pixels: a few stray
/// points would leave none to grow on. Else none. Ascending, as the candidates are.
std::vector<uint32_t> far_candidates(const SegmentScene& scene,
                                     std::span<const uint32_t> candidates, const ImageAxes& axes,
                                     double pixel_m, Task& task);

}  // namespace jalon
