// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "base/task.h"
#include "geometry/vec.h"

namespace jalon {

using Triangle2 = std::array<uint32_t, 3>;

/// The border of triangles joined edge to edge: closed rings of point indices with the triangles on the left, so the
/// outer ring runs anticlockwise and the others clockwise. No index stands twice in a ring.
struct BoundaryPiece {
  double area = 0;
  std::vector<std::vector<uint32_t>> rings;
};

/// Before: triangles anticlockwise, each undirected edge in at most two. After: pieces in the order
/// of their first triangle, their areas above 0; every edge with one triangle stands in one ring.
/// O(t log t).
std::vector<BoundaryPiece> boundary_rings(std::span<const Triangle2> triangles,
                                          std::span<const Vec2> points, Task& task);

}  // namespace jalon
