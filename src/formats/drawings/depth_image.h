// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "base/task.h"
#include "cloud/cloud.h"
#include "formats/settings.h"
#include "geometry/vec.h"

namespace jalon {

/// Most pixels of a depth image that is read or written.
inline constexpr uint64_t kMostDepthPixels = uint64_t{1} << 28;
/// Of a pixel that no point lies in.
inline constexpr double kNoDepth = -INFINITY;

/// To the right, upward and toward the viewer of a depth image.
struct DepthAxes {
  Vec3 u, v, n;
  std::array<double, 3> of(const Vec3& p) const { return {dot(p, u), dot(p, v), dot(p, n)}; }
};

/// A cloud as seen from one direction: of each pixel the point nearest to the viewer.
struct DepthRaster {
  DepthAxes axes;
  std::array<double, 3> low{};  ///< least coordinates of the points along the axes
  double range_m = 0;           ///< from the farthest point to the nearest
  double pixel_m = 1;
  uint32_t columns = 0, rows = 0;
  std::vector<double> depths;  ///< along axes.n, rows from the top
};

/// As the options "png_direction" and "png_pixel_m" say; path: for messages.
DepthRaster depth_image_of(const Cloud& cloud, const WriteSettings& settings,
                           const std::string& path, Task& task);

}  // namespace jalon
