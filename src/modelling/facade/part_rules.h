// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "geometry/vec.h"

namespace jalon {

/// A face that is no wall, in the coordinates of its facade: x along it, y out of it, z up.
struct ElementShape {
  Box3 box;
  Vec3 normal;
  double area_m2 = 0;
};

/// What the rule compares an element with.
struct FacadeShape {
  Box3 box;  ///< of the walls
  std::vector<Box3> openings;
};

/// Class of an element by its position, size, depth and orientation; the words of part_classes.h. The rule, the first
/// that holds:
/// - ground: level, of 2 m2 or more, no more than 1 m above the foot of the facade, reaching out before it;
/// - sill: below an opening, hardly wider than it, in front of the wall, up to 0.5 m high;
/// - roof: level or inclined, of 4 m2 or more, at the top of the facade and behind its front;
/// - cornice: long, in front of the wall, at its top (upright, or level as its underside and top);
/// - base_course: long, in front of the wall, at its foot, up to 1.5 m high;
/// - string_course: long, in front of the wall, up to 1 m high or deep;
/// - post: upright, in front of the wall, up to 1 m wide and 3 times as high;
/// - element: everything else.
const char* class_of_element(const ElementShape& element, const FacadeShape& facade);

/// Numbers for names, in reading order of a facade: the row counted from below, then the place in the row from the
/// left: "1.1", "1.2", ... "2.1". Boxes belong to one row when their middles' heights differ by less than half the
/// lower one's height.
std::vector<std::string> row_numbers(const std::vector<Box3>& boxes);

}  // namespace jalon
