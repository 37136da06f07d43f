// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "modelling/walls/holes.h"
#include "modelling/walls/survey.h"

namespace jalon {

/// Of a sill's front: stone sills have 0.08 to 0.25 m.
inline constexpr double kMostSillHeight_m = 0.35;

/// A sill that stands out hides the wall behind it and the foot of the opening above: the hole in
/// the wall's points goes down to the sill's underside and is as wide as the sill there. Ends such
/// holes, and the rings of the wall's faces with them, at the upper edge of the sill's front, with
/// the jambs straight down to it. The front is a plane of its own, or, where it has too few points
/// for one, the points seen before the hole's foot; its upper edge lies between the last points of
/// all their columns and a row's distance above them (upper_edge).
///
/// Before: planes are of all segments, wall is the index of one; survey and holes are of that wall;
/// front_m: farthest that a sill stands out. After: a hole that ends at a sill says so and begins
/// with its edge there, and the wall's face has the same ring; the others are as they were. O(holes
/// x (planes + points)).
void end_at_sills(std::vector<VectorPlane>& planes, size_t wall, const WallSurvey& survey,
                  double front_m, std::vector<WallHole>& holes);

}  // namespace jalon
