// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "registration/joint/joint_points.h"
#include "registration/joint/strip_scene.h"

namespace jalon {

/// What became of a point; the numbers of jalon/adjustment.h.
enum class MatchState : uint8_t {
  kMatched = 1,
  kNothing = 2,   ///< the ray meets no strip, or a roof or the ground before
  kBehind = 3,    ///< the ray meets a strip from inside the building
  kFar = 4,       ///< farther from the strip's plane than the sigmas allow
  kTurned = 5,    ///< the wall that the point is of stands otherwise than the strip
  kUnsteady = 6,  ///< its match changed again in a late pass
};

struct PointMatch {
  uint32_t strip = kNoStrip;  ///< the one that the ray meets, accepted or not
  MatchState state = MatchState::kNothing;
  double distance_m = 0;  ///< of the moved point from the moved strip's plane, positive in front

  bool operator==(const PointMatch& b) const { return strip == b.strip && state == b.state; }
};

/// Where everything stands at a pass.
struct JointPlaces {
  std::vector<Vec2> trajectory;  ///< corrections at the control times
  BuildingOffsets model;
};

/// Each point to the first strip that its own ray meets, both moved to where they stand now; accepted when the strip
/// faces the laser and the point is within so many standard deviations of its plane. O(points log strips), parallel.
/// With matches = ids the strip is the field's, and all are accepted.
std::vector<PointMatch> match_points(const JointPoints& points, const StripScene& scene,
                                     const JointPlaces& places, const JointSettings& settings,
                                     Task& task);

/// The standard deviations that a point may be off: -log of the share, or the normal distribution's.
double greatest_deviation(const JointSettings& settings);

}  // namespace jalon
