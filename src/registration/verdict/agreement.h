// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "registration/verdict/sights.h"

namespace jalon {

/// What one cloud's surfels say of the other at a pose; numbers of surfels.
struct Agreement {
  size_t surfels = 0;
  size_t near = 0;          ///< within reach of the other cloud's points
  size_t explained = 0;     ///< of those that the other could see, on its surface
  size_t unexplained = 0;   ///< near it, seen from the same side, and yet on none of its surfaces
  size_t seen = 0;          ///< where the other's stations measured a surface or looked through
  size_t pierced = 0;       ///< of those: its beams went through, here and about here
  size_t contradicted = 0;  ///< unexplained or pierced, as are most about it: a thing, not an edge
  /// The greatest share pierced of those that face one of the three axes.
  double worst_pierced = 0;

  double explained_share() const { return share(explained, explained + unexplained); }
  double pierced_share() const { return share(pierced, seen); }
  double contradicted_share() const { return share(contradicted, judged); }
  double near_share() const { return share(near, surfels); }
  size_t judged = 0;        ///< explained, unexplained or pierced
  bool has_sights = false;  ///< of the other cloud: seen and pierced were measured

 private:
  static double share(size_t part, size_t whole) {
    return whole == 0 ? 0 : static_cast<double>(part) / static_cast<double>(whole);
  }
};

/// As far as two clouds know where a surface is between their points: the larger spacing of the two, m.
double reach_of(const JudgedCloud& a, const JudgedCloud& b);

/// Holds surfels of one cloud, every so many of them, against the other. O(surfels log n).
Agreement agreement_of(const JudgedCloud& of, const JudgedCloud& with, const Transform& T_with_of,
                       Task& task, size_t every = 1);

}  // namespace jalon
