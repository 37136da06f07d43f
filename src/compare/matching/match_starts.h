// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "compare/matching/rigid_match.h"

namespace jalon {

/// Upright box around points that stand on something, turned about the support's normal to the least area.
struct StandingBox {
  Vec3 up, across, along;  ///< orthonormal, along x across = up
  Vec3 centre;
  double half[3] = {0, 0, 0};  ///< along, across, up
  bool contains(const Vec3& p, double margin) const;
};
StandingBox standing_box(const std::vector<Vec3>& points, const Vec3& up);

/// First guesses T_after_before: none; shifts of the centroid and the box; for what stands, the turns about up that lay
/// one box on the other, and where only their heights differ the quarter turns of what fell over; else those that lay
/// the principal axes on each other.
std::vector<Transform> match_starts(const MatchSurface& before, const MatchSurface& after,
                                    const MatchSetting& setting);

}  // namespace jalon
