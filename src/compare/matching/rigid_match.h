// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include "compare/matching/match_surface.h"
#include "geometry/cholesky.h"
#include "geometry/vec.h"

namespace jalon {

/// Could the scanners of an epoch have seen something at this place? Empty: everything counts as visible.
using SeenTest = std::function<bool(const Vec3&)>;

struct MatchSetting {
  double tolerance_m = 0.02;  ///< farther from the other surface than this is not the same surface
  bool stands = false;        ///< on a support: turns about its normal are tried first, and falls
  Vec3 up{0, 0, 1};
  SeenTest seen_before, seen_after;  ///< by the stations of either epoch
  /// Share of the points that must have been in sight of the other scanners for anything to be explained.
  double judged = 0.7;
};

/// How well one rigid motion lays the object before onto the object after.
struct RigidMatch {
  bool found = false;
  Transform motion;             ///< T_after_before
  Vec3 rotation, displacement;  ///< rotation vector; what the object's centroid moved by
  Square<6> covariance{};       ///< of rotation (rad) and displacement (m)
  double explained =
      0;  ///< share of the points of both, where they could be seen, that lie on the other
  double rms_m = 0;
};

/// 1. Starts from the boxes and axes of both; 2. point-to-plane iterations from each on a sample, with a shrinking
/// reach (Chen & Medioni 1992; Girardeau-Montaut 2006, 2.1); 3. the start that explains most, the smaller motion of
/// equals; 4. adjustment with all points.
RigidMatch match_rigidly(const MatchSurface& before, const MatchSurface& after,
                         const MatchSetting& setting, Task& task);

/// Of points that a motion moves: how many come to lie on a surface, of those that could have been seen there.
struct LaidOn {
  size_t on = 0, all = 0;
  LaidOn& operator+=(const LaidOn& b) {
    on += b.on;
    all += b.all;
    return *this;
  }
  double share() const { return all > 0 ? static_cast<double>(on) / static_cast<double>(all) : 0; }
};
LaidOn laid_on(const std::vector<Vec3>& points, const Transform& motion,
               const MatchSurface& surface, const SeenTest& seen, double tolerance_m, Task& task);

}  // namespace jalon
