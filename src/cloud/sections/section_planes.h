// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "cloud/cloud.h"
#include "cloud/sections/section_settings.h"

namespace jalon {

/// Where a cloud is cut: u to the right and v upward in the drawing, the normal toward the viewer.
struct SectionPlane {
  double at_m = 0;  ///< along the direction, or station of the alignment
  Vec3 origin, u, v, normal;
  /// u, v, and the distance from the plane.
  Vec3 near(const Vec3& p) const {
    return {dot(p - origin, u), dot(p - origin, v), dot(p - origin, normal)};
  }
  Vec3 place(const Vec2& p) const { return origin + p.u * u + p.v * v; }
};

/// Across one direction: level ones are seen from above, others look along the direction. Places from the settings,
/// ascending; Error(kLimit) where these name far too many.
std::vector<SectionPlane> planes_along_direction(const Cloud& cloud,
                                                 const SectionSettings& settings, Task& task);
/// Upright ones across an alignment in plan, which look along it: the origin lies on it at height 0, so that u is the
/// offset to the right and v the height.
std::vector<SectionPlane> planes_along_alignment(std::span<const Vec3> alignment,
                                                 const SectionSettings& settings);

/// Points within half the thickness of a plane and, where reach_m > 0, within it of the origin to both sides. For each
/// plane the indices, ascending; a point may be of several. O(n log planes) for parallel planes.
std::vector<std::vector<uint32_t>> points_of_planes(const Cloud& cloud,
                                                    std::span<const SectionPlane> planes,
                                                    double thickness_m, double reach_m, Task& task);

}  // namespace jalon
