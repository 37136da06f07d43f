// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "registration/icp_face_plane.h"
#include "registration/icp_planes.h"

namespace jalon {

/// The points that the plane of a point goes through.
struct PlaneMembers {
  std::vector<uint32_t> positions;
  PlanePoints points;
  Vec3 u, v;               ///< axes in the plane
  double uu_m2 = 0, vv_m2 = 0;  ///< sums of squares along them
  /// S^-1 of an offset from the centroid, in the plane.
  Vec3 pull(const Vec3& offset_m) const {
    return u * (dot(u, offset_m) / uu_m2) + v * (dot(v, offset_m) / vv_m2);
  }
};
PlaneMembers plane_members(const SurfacePlanes& planes, uint32_t position, uint32_t k);

}  // namespace jalon
