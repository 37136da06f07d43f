// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/plane/segment_frame.h"

#include <cmath>

namespace jalon {

PlaneFrame segment_frame(const Segmentation& segmentation, const Segment& segment,
                         std::span<const uint32_t> indices) {
  Box3 box;
  for (const uint32_t i : indices) box.add(segmentation.cloud->point(i));
  const Vec3 corner{std::floor(box.min.x), std::floor(box.min.y), std::floor(box.min.z)};
  const auto& m = segmentation.T_facade_world.m;
  return plane_frame(segment.fit.plane, corner, {m[0], m[1], m[2]});
}

}  // namespace jalon
