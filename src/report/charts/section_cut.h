// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "compare/clearance/part_triangles.h"
#include "geometry/vec.h"

namespace jalon {

/// Where a surface meets the plane z = back_m of a section's frame: a line for each triangle that crosses it, those
/// that lie in it left out. O(triangles).
std::vector<std::array<Vec2, 2>> section_cut(const PartTriangles& surface, const Transform& section,
                                             double back_m);

/// The part of a line within a box (Liang & Barsky 1984), if there is one.
std::optional<std::array<Vec2, 2>> clipped_to(const Vec2& low, const Vec2& high,
                                              const std::array<Vec2, 2>& line);

}  // namespace jalon
