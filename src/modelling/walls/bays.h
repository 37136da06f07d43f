// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "modelling/walls/holes.h"
#include "modelling/walls/survey.h"

namespace jalon {

/// Openings between pieces of a wall: shop fronts between piers whose tops a sign board or an
/// awning hides, so that no face of the wall runs round them. Row by row over the wall, gaps
/// between two pieces that stay where they are for min_height_m, with wall somewhere above them.
/// Upright rectangles, each side where a good part of the rows have wall, so that what stands
/// before a pier (a bin, a passer-by) does not move it.
///
/// After: from left to right, without those that a hole given takes up; outlines start at the left
/// foot as those of notches do, and no face has them. O(rows x corners).
std::vector<WallHole> bays_of(const VectorPlane& wall, std::span<const WallHole> holes,
                              const NotchSetting& setting);

/// Whether another wall, this far behind at most, stands in the bay: then it is no opening.
bool is_walled_up(const WallHole& bay, const VectorPlane& wall, const VectorPlane& other,
                  double max_depth_m);

/// What is seen behind a bay tells how far up it goes: above may be what hid the piers' tops.
/// Lowers its head to there. False, and nothing has changed: too little is seen, and it may be a
/// way between two houses as well. survey: of this bay.
bool fit_to_content(WallHole& bay, const HoleSurvey& survey, const WallMap& map,
                    double tolerance_m);

}  // namespace jalon
