// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "base/task.h"
#include "geometry/vec.h"

namespace jalon {

/// How the sides of triangles meet; corners with equal coordinates are one.
struct MeshClosure {
  uint64_t border_sides = 0;  ///< an odd number of triangles along them
  uint64_t inconsistent_sides =
      0;  ///< an even number, not as many in one direction as in the other
  bool is_closed() const { return border_sides == 0 && inconsistent_sides == 0; }
};
/// Triangles without area, two of whose corners are one, have no sides. O(n log n).
MeshClosure closure_of(std::span<const Vec3> vertices,
                       std::span<const std::array<uint32_t, 3>> triangles, Task& task);

/// What closed triangles enclose (divergence theorem); negative when they run clockwise seen from outside.
double enclosed_volume(std::span<const Vec3> vertices,
                       std::span<const std::array<uint32_t, 3>> triangles, Task& task);

}  // namespace jalon
