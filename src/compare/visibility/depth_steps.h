// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "base/task.h"

namespace jalon {

/// A point as a station sees it, in single precision: 2e-7 rad.
struct Seen {
  float horizontal_rad, vertical_rad, range_m;
};

/// The rectangle of the two angles that a station looked at.
struct AngularField {
  double horizontal_from_rad = 0, horizontal_extent_rad = 0;  ///< from -pi on; clockwise
  double vertical_from_rad = 0, vertical_extent_rad = 0;
  bool is_closed = false;  ///< the whole circle
};

/// The field without the widest gap around the circle. One narrower than 0.05 rad (a mast, a person) opens no circle.
AngularField angular_field(std::span<const Seen> points, Task& task);

struct AngularSteps {
  double horizontal_rad, vertical_rad;
};

/// The scanner's steps, whatever the order of the points: the median distances to the next point across and along, in
/// windows of about the median density over the field, so that one scanned finer does not count for more than its area.
/// A lattice has one point in each product of the two: where that is off the density by more than a factor of three,
/// both steps are the side of the square that holds one point. O(n).
AngularSteps angular_steps(std::span<const Seen> points, const AngularField& field, Task& task);

}  // namespace jalon
