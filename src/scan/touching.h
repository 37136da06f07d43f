// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/task.h"
#include "geometry/plane.h"
#include "geometry/vec.h"
#include "spatial/union_find.h"

namespace jalon {

/// A triangle with an area, relative to the origin of the work.
struct FlatTriangle {
  std::array<Vec3, 3> corners;
  Plane plane;
  double area = 0;
  uint32_t number = 0;  ///< in the model
};

/// Normals within 0.001 degrees (whichever side), and the corners of each within 0.1 mm of the other's plane.
bool are_coplanar(const FlatTriangle& a, const FlatTriangle& b);

/// Joins coplanar groups of triangles that come within 0.1 mm of each other. Groups must be connected and coplanar.
void join_touching(const std::vector<FlatTriangle>& flats, UnionFind& groups, Task& task);

}  // namespace jalon
