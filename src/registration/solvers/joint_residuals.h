// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "registration/solvers/joint_problem.h"

namespace jalon {

/// What the values of a solution should have been, where the truth is known: in its order.
struct JointTruth {
  std::vector<Vec2> trajectory, blocks;
  std::vector<double> facades, strips;
  Vec3 attitude_rad{};
};

enum JointGroup : size_t {
  kTrajectoryX,
  kTrajectoryY,
  kBlocksX,
  kBlocksY,
  kFacades,
  kStrips,
  kJointGroups
};

/// (adjusted - true) / sigma, group by group: standard normal one by one where the priors are right. Those of one
/// draw hang together, so that their mean and spread may be far from 0 and 1 (a drift of the whole drive is one
/// value).
std::array<std::vector<double>, kJointGroups> normalised_residuals(const JointSolution& solution,
                                                                   const JointTruth& truth);

/// Mean square of L^-1 (adjusted - true) over trajectory, blocks and turns, L L^T their covariance, which the solution
/// must have: chi-square over its degrees of freedom, 1 on average, whatever hangs together.
double whitened_mean_square(const JointSolution& solution, const JointTruth& truth);

}  // namespace jalon
