// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "registration/solvers/joint_problem.h"

namespace jalon {

/// Where a strip is given: normal . p = offset.
struct GivenStrip {
  uint32_t block = 0, facade = 0;
  Vec2 normal;
  double offset_m = 0;
  double place_m = 0;  ///< of its middle along the facade
};

/// Points with their times and the strip that each is matched to; a number that is no strip's matches
/// nothing.
struct MatchedPoints {
  std::span<const double> xyz, times_s;
  std::span<const uint32_t> strips;
  std::span<const double> weights{};  ///< empty: all count alike; 0: the point does not count
  /// Derivatives of each point by turns of its vehicle (m/rad); empty: attitudes stay.
  std::span<const std::array<Vec2, 3>> turns{};
};

struct StripConditions {
  std::vector<StripCondition> conditions;
  std::vector<uint32_t> strip_of;  ///< of each condition: which of the given strips
  std::vector<uint64_t> points;    ///< of each condition, those that count
};
/// One condition for each strip with least_points points and more. Points outside of the control times
/// are left out. sigma_range_m: of a single point along the normal. O(points + strips).
StripConditions strip_conditions(const MatchedPoints& points, std::span<const GivenStrip> strips,
                                 std::span<const double> control_times_s, uint64_t least_points,
                                 double sigma_range_m);

/// The level direction that the normals of strips hold least, and its share of what the best held one is held by: 0
/// where all walls are parallel. Eigenvectors of the sum of n n^T.
struct WeakDirection {
  Vec2 direction;
  double share = 0;
};
WeakDirection weak_direction(std::span<const StripCondition> strips);

}  // namespace jalon
