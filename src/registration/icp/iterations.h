// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "registration/icp/normal.h"
#include "registration/icp/patch_fit.h"
#include "registration/icp/settings.h"
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

/// Where the iterations are, and how they got there.
struct IcpState {
  Transform inner;       ///< between the frames of the two trees
  Vec3 centre;           ///< that turns are about, in the moving frame
  double extent_m = 1;
  double distance_m = 0; ///< greatest residual of a pair
  double sigma_m = 0;    ///< of the residuals, from their median
  double worst_m = 0;    ///< the distance, or what trimming leaves of it
  StopReason stopped = StopReason::kIterationLimit;
  IcpSums sums;          ///< of the last step
  IcpDirections directions;
  std::vector<IcpIteration> log;
  IcpNeighbours neighbours;  ///< of the last step, with their rule and kernel
  PairRule rule;
  RobustKernel kernel;
  PatchSums patches;  ///< of the last step on patches, where the pose settled on them

  IcpFrame frame() const { return {inner.point(centre), extent_m}; }
};

/// Iterates at one level until the steps are small against what the noise leaves open (converged), the pairs are too
/// few, or the iterations are used up. False when there is no use in going on.
bool icp_iterate(const IcpClouds& clouds, const IcpPoints& reference, const IcpPoints& moving, int level, bool last,
                 const IcpSettings& settings, Task& task, IcpState& state);

}  // namespace jalon
