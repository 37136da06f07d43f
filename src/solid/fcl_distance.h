// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

#include "geometry/vec.h"
#include "solid/triangle_boxes.h"

// The only files that see FCL and libccd are fcl_*.cpp; in a build without them fcl_absent.cpp stands in.

namespace jalon {

struct TrianglePair {
  uint32_t first = 0, second = 0;
  double distance_m = 0;  ///< 0 where they meet; then the points are any of either
  Vec3 first_point, second_point;
};

/// Throws kUnsupported without FCL, kInternal when the libccd that was loaded calculates in single precision.
void require_fcl();
/// The nearest pair of two sets of triangles (FCL's trees of oriented boxes and swept spheres).
TrianglePair nearest_pair(const TriangleBoxes& first, const TriangleBoxes& second);
/// Two triangles; exact to rounding (the test of PQP, Larsen et al. 1999).
double triangle_distance(const std::array<Vec3, 3>& first, const std::array<Vec3, 3>& second,
                         Vec3& first_point, Vec3& second_point);

}  // namespace jalon
