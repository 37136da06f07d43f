// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "base/task.h"
#include "geometry/vec.h"
#include "spatial/triangles/nearest_kernel.h"

namespace jalon {

/// Triangles on one another, of which one stands for all.
struct TriangleStack {
  int alike = 1;     ///< that run around as that one does, itself counted
  int reversed = 0;  ///< the other way around
};

/// The triangles of a mesh, those of each high stack once.
struct TriangleStacks {
  std::vector<uint32_t> distinct;     ///< caller's numbers, ascending
  std::vector<TriangleStack> stacks;  ///< of each of them
};

/// Of a leaf's triangles, whose corners stand at these places, those whose corners are as near to the first one's.
size_t stacked_in(const TriangleBlock& block, const double* corners, double near_m);

/// A stack of fewer is left as it is: its triangles stand for themselves.
constexpr size_t kHighStack = 16;

/// Triangles whose corners fall into the same cells of this size about the origin (m) lie on one another; a stack on
/// the border of a cell may come out as a few. Triangles that are hardly larger than a cell stay by themselves. The
/// same for any number of threads; O(n log n).
TriangleStacks triangle_stacks(std::span<const Vec3> vertices,
                               std::span<const std::array<uint32_t, 3>> triangles,
                               const Vec3& origin, double cell_m, Task& task);

}  // namespace jalon
