// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/vec.h"

namespace jalon {

// Polygons are corner lists without a repeated last corner; the last corner joins the first.

/// Half the sum of cross products: positive when the corners run anticlockwise. Taken about the
/// first corner, so that large coordinates lose nothing.
double signed_area(std::span<const Vec2> polygon);
double perimeter(std::span<const Vec2> polygon);
/// Even-odd rule; a point exactly on the border is inside.
bool contains(std::span<const Vec2> polygon, const Vec2& p);
double segment_distance(const Vec2& p, const Vec2& a, const Vec2& b);
/// Distance to the border; infinity for an empty polygon.
double border_distance(std::span<const Vec2> polygon, const Vec2& p);

/// Indices of the corners that Douglas & Peucker (1973) keep: every dropped corner lies within
/// tolerance of its segment. Open lines keep both ends; closed ones keep the first corner and the
/// one farthest from it. Ascending. Ties go to the lower index.
std::vector<uint32_t> simplified(std::span<const Vec2> line, double tolerance, bool is_closed);

/// Corners of the convex hull, anticlockwise from the leftmost-lowest, no three collinear (Andrew
/// 1979). Fewer than three distinct points, or collinear ones: the one or two extreme points.
std::vector<uint32_t> convex_hull(std::span<const Vec2> points);

/// Do the closed segments ab and cd cross, touch or overlap? Exact for coordinates whose products are exact.
bool segments_meet(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d);
/// No two borders meet but neighbours in their common corner. O(n^2), for tests and small outlines.
bool is_simple(std::span<const Vec2> polygon);

}  // namespace jalon
