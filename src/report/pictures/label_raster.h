// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/task.h"
#include "geometry/vec.h"
#include "segment/segmentation.h"

namespace jalon {

/// What a picture of labelled points looks along.
enum class PictureView { kFront, kPlan };

/// From world to picture coordinates (m), and how far into the picture a point lies.
struct Projection {
  Vec3 origin, right, up, into;
  Vec2 shift;  ///< picture coordinates of the origin
  Vec2 flat(const Vec3& p) const {
    return {dot(p - origin, right) + shift.u, dot(p - origin, up) + shift.v};
  }
  double depth(const Vec3& p) const { return dot(p - origin, into); }
};

/// Labelled points seen from a far away eye: the label of the nearest segment's point in each pixel, rows from the top.
struct LabelRaster {
  static constexpr uint32_t kEmpty = 0, kNoise = ~uint32_t{0};
  uint32_t columns = 0, rows = 0;
  double pixel_m = 1;
  Vec2 low;                      ///< left lower corner: along the facade or X; Z or Y
  std::vector<uint32_t> labels;  ///< a segment's, kNoise or kEmpty

  double width_m() const { return columns * pixel_m; }
  double height_m() const { return rows * pixel_m; }
};

/// Rasterises the points in the box of the segments (of all points when there are none). Noise shows only where no
/// segment does, so that stray points before a facade do not hide it. At most kMaxPicturePixels pixels; where points
/// are sparser than pixels they are drawn larger. Empty where they spread over more than 1e9 m.
LabelRaster rasterise_labels(const Segmentation& segmentation, PictureView view, Task& task);

/// The same of any cloud and labels, one a point; label 0 is what noise is.
LabelRaster rasterise_points(const Cloud& cloud, std::span<const uint32_t> labels,
                             const Projection& projection, Task& task);

constexpr double kMaxPicturePixels = 1e6;  // worst case 9 bits each: with base64 below 1.6 MB

}  // namespace jalon
