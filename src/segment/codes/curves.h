// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "geometry/vec.h"

namespace jalon {

struct LinkagePoint {
  Vec2 at;
  bool on_curve = false;  ///< measured along a bend
};

/// The line through the points of a linkage: straight between two of them unless one was measured along a bend. A span
/// of a bend is the circle through it and the point before, blended into that through it and the point after: exact
/// where the bend is a circle. Chords of about 1 mm sagitta.
std::vector<Vec2> linkage_line(std::span<const LinkagePoint> points, bool is_closed);

}  // namespace jalon
