// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "registration/joint/facade_exchange.h"
#include "registration/joint/ray_matching.h"

namespace jalon {

/// The state of the loop that claims are judged by.
struct LoopState {
  const JointPoints& points;
  const StripScene& scene;
  const JointPlaces& places;
  const std::vector<PointMatch>& matches;
  const std::vector<double>& weights;  ///< of the matches; 0: the point is evidence of no strip
};

/// Which facades may be the walls that others stand on, within their sigma: parallel ones, along whose normals the
/// points lie. A claim is worth 1 a point on the facade (tempered, as points of a wall hang together), less the beams
/// through it, half the square of its offset in standard deviations, and half of that of the turn between facade and
/// wall, in standard deviations of what strips that are each off by themselves show of one. Points of a third facade
/// are nobody's. By facades, ascending by wall. O(points + walls (points and strips about them)), parallel.
std::vector<FacadeClaim> wall_claims(const LoopState& state, const JointSettings& settings,
                                     Task& task);

/// By the sigmas: facades may be off by more than the loop bridges.
bool is_facade_exchange_wanted(const JointSettings& settings);

}  // namespace jalon
