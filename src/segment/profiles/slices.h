// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/plane.h"
#include "segment/surface/scene.h"

namespace jalon {

/// How a cloud is cut.
struct SliceRule {
  Vec3 axis;  ///< across the slices
  double step_m = 0, thickness_m = 0;
  double cell_m = 0;       ///< points closer together than this are one
  double gap_m = 0;        ///< where a profile breaks off
  double tolerance_m = 0;  ///< of its lines
};

/// A straight piece of a slice's profile.
struct ProfileLine {
  uint32_t slice = 0;
  Vec2 from, to;                    ///< in the slice: ends of the least-squares line
  Moments moments;                  ///< of its points, about the middle of the scene
  std::vector<uint32_t> positions;  ///< of its points in the scene
};

/// All straight pieces of the slices at multiples of the step, slice by slice: points of each slice thinned, chained
/// and simplified, each piece fitted to its nodes.
std::vector<ProfileLine> profile_lines(const SegmentScene& scene, const SliceRule& rule,
                                       Task& task);

}  // namespace jalon
