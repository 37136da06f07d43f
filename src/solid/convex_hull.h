// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/vec.h"

namespace jalon {

/// Convex hull as triangles, their unit normals outward; facets of one plane stay several triangles.
struct ConvexHull {
  struct Facet {
    std::array<uint32_t, 3> corners{};
    Vec3 normal;
    double offset = 0;  ///< normal . p = offset
  };
  std::vector<Vec3> corners;  ///< of the hull alone
  std::vector<Facet> facets;
};

constexpr size_t kMaxHullPoints = 4096;

/// Points are added one by one: the facets that see a point give way to new ones around it (de Berg et al. 2008,
/// Computational Geometry, 11.2). Orientations are exact, on integers of 2^-36 of the extent (0.2 nm for 10 m), so
/// that flat sides and repeated points are no special case. Throws kInsufficientData below 4 points, kDegenerate when
/// all lie in a plane but for 2^-33 of the extent or eight roundings of the coordinates (1 nm for 10 m, 12 nm at 7
/// million metres), kLimit above kMaxHullPoints. O(n f).
ConvexHull convex_hull(std::span<const Vec3> points);

}  // namespace jalon
