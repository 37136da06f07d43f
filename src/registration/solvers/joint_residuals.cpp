// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/solvers/joint_residuals.h"

#include <cmath>

#include "base/error.h"

namespace jalon {

std::array<std::vector<double>, kJointGroups> normalised_residuals(const JointSolution& s,
                                                                   const JointTruth& truth) {
  std::array<std::vector<double>, kJointGroups> z;
  const auto pairs = [&](JointGroup x, JointGroup y, const std::vector<Vec2>& values,
                         const std::vector<Vec2>& sigmas, const std::vector<Vec2>& expected) {
    for (size_t i = 0; i < values.size(); ++i) {
      z[x].push_back((values[i].u - expected[i].u) / sigmas[i].u);
      z[y].push_back((values[i].v - expected[i].v) / sigmas[i].v);
    }
  };
  pairs(kTrajectoryX, kTrajectoryY, s.trajectory, s.trajectory_sigmas, truth.trajectory);
  pairs(kBlocksX, kBlocksY, s.blocks, s.blocks_sigmas, truth.blocks);
  for (size_t f = 0; f < s.facades.size(); ++f)
    z[kFacades].push_back((s.facades[f] - truth.facades[f]) / s.facades_sigmas[f]);
  for (size_t i = 0; i < s.strips.size(); ++i)
    z[kStrips].push_back((s.strips[i] - truth.strips[i]) / s.strips_sigmas[i]);
  return z;
}

double whitened_mean_square(const JointSolution& s, const JointTruth& truth) {
  JointOrder at{s.trajectory.size(), s.blocks.size()};
  const auto n = s.covariance.rows();
  constexpr size_t kTurns = 3;
  if (n == static_cast<Eigen::Index>(at.size() + kTurns)) at.turns = kTurns;
  if (n != static_cast<Eigen::Index>(at.size()))
    fail(Status::kInternal, "whitened residuals need the covariance of the solution");
  Eigen::VectorXd off(n);
  const auto set = [&](size_t x, size_t y, const Vec2& value, const Vec2& expected) {
    off[static_cast<Eigen::Index>(x)] = value.u - expected.u;
    off[static_cast<Eigen::Index>(y)] = value.v - expected.v;
  };
  for (size_t c = 0; c < at.controls; ++c)
    set(at.tx(c), at.ty(c), s.trajectory[c], truth.trajectory[c]);
  for (size_t b = 0; b < at.blocks; ++b) set(at.dx(b), at.dy(b), s.blocks[b], truth.blocks[b]);
  for (size_t k = 0; k < at.turns; ++k) {
    const auto axis = static_cast<int>(k);
    off[static_cast<Eigen::Index>(at.turn(k))] = s.attitude_rad[axis] - truth.attitude_rad[axis];
  }
  return off.dot(s.covariance.ldlt().solve(off)) / static_cast<double>(n);
}

}  // namespace jalon
