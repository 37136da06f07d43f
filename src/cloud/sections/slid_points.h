// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "base/task.h"
#include "geometry/vec.h"

namespace jalon {

/// Points near the plane of a section (u, v, distance from it), each slid onto it along the surface that it lies on. A
/// surface that meets the plane at an angle would else be as broad in the drawing as the points lie apart across it.
/// 1. the points by square cells of twice the thickness; 2. a plane for each cell and its neighbours (orthogonal least
/// squares), where they are one surface and its lean is no noise; 3. each point along that of those about it whose lean
/// is known best. What lies on none stays above its foot, and so does what meets the plane at 20 degrees or less.
/// tolerance_m: farthest from a surface. Sorted: the same for any order. O(n log cells).
std::vector<Vec2> slid_points(std::vector<Vec3> points, double thickness_m, double tolerance_m,
                              Task& task);

}  // namespace jalon
