// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "segment/segmentation.h"

namespace jalon {

/// Points of a cloud that are known to belong together.
struct GivenPoints {
  const Cloud& cloud;
  std::span<const uint32_t> indices;
  Vec3 origin;  ///< local; the fit is relative to it
  Vec3 local(size_t i) const { return cloud.point(indices[i]) - origin; }
};

/// Their least-squares plane, extents and area. Without a plane everything but the number of points is NaN. pixel_m:
/// raster for the area; 0 = four points a pixel on average, what the segmenter's twice the spacing comes to.
Segment describe_given(const GivenPoints& points, double pixel_m, Task& task);

}  // namespace jalon
