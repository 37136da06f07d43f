// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "registration/icp/patch_fit.h"
#include "registration/icp/problem.h"
#include "registration/registration.h"

namespace jalon {

/// One row of the log.
struct IcpIteration {
  int level = 0;  ///< 0: the fewest points
  uint64_t pairs = 0;
  double kept = 0;  ///< share of the moving points of the level that have a pair
  double rms_m = 0, sigma_m = 0, distance_m = 0;
  double turn_rad = 0, shift_m = 0;  ///< of the step
  uint8_t observable = 0;            ///< directions
};

/// What the last step was made of, and what came out; for the covariance.
struct IcpLastStep {
  IcpNeighbours neighbours;
  PairRule rule;
  RobustKernel kernel;
  IcpSums sums;
  IcpDirections directions;
};

/// Where the iterations are, and how they got there.
struct IcpState {
  Transform T_reference_moving;
  double distance_m = 0;           ///< greatest residual of a pair, as it shrinks
  double sigma_m = 0;              ///< of the residuals, from their median
  double over_noise = kOverNoise;  ///< of directions that are observable
  StopReason stopped = StopReason::kIterationLimit;
  std::vector<IcpIteration> log;
  IcpLastStep last;
  PatchSums patches;  ///< of the last step on patches, where the pose settled on them

  /// The last step's pairs at the present pose. level: the one that it was made at.
  IcpPairing pairing(const IcpProblem& problem, const IcpLevel& level) const {
    return {problem.clouds, level, last.neighbours, last.rule, T_reference_moving};
  }
  /// They are of all points: the iterations got to the last level.
  bool has_all(const IcpProblem& problem) const {
    return last.neighbours.of_moving.size() == problem.clouds.moving.size();
  }
};

/// Iterates at one level until the steps are small against what the noise leaves open (converged),
/// the pairs are too few, or the iterations are used up. False when there is no use in going on.
///
/// Before: state has a pose and a greatest distance above 0. After: the pose has moved, the log has
/// a row a step, stopped says why, and last is of this level.
bool icp_iterate(const IcpProblem& problem, const IcpLevel& level, IcpState& state, Task& task);

}  // namespace jalon
