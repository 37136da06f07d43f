// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "registration/verdict/agreement.h"

namespace jalon {

/// A direction of a pose: a turn about a centre and a shift together.
struct SlideWay {
  Vec3 centre;         ///< in the reference
  Vec3 turn_rad, way;  ///< of a slide by one metre
};

/// What two clouds say when the pose is slid along a direction that the pairs leave open.
struct Slide {
  bool is_fixed = false;  ///< a little way off on either side they agree clearly less
  double better_m = 0;    ///< where they agree clearly better than at the pose; 0: nowhere
};

/// Pairs at one pose tell a direction by the scatter of normals alone, which noise hides and which robust weights cut
/// down to the surfaces that slide on themselves. Slid, windows meet walls: that is told by surfaces far larger than
/// the neighbours of a normal. Looks farthest_m each way. O(surfels log n) for each of some 130 places.
Slide slide_along(const JudgedCloud& reference, const JudgedCloud& moving,
                  const Transform& T_reference_moving, const SlideWay& along, double farthest_m,
                  Task& task);

}  // namespace jalon
