// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/solvers/joint_problem.h"

#include "base/error.h"

namespace jalon {

void validate(const JointProblem& problem) {
  const double sigmas[] = {problem.sigma_block_x_m, problem.sigma_block_y_m, problem.sigma_facade_m,
                           problem.sigma_strip_m};
  const char* names[] = {"of blocks along x", "of blocks along y", "of facades", "of strips"};
  for (size_t k = 0; k < 4; ++k)
    if (!(sigmas[k] >= 0)) fail(Status::kInvalidArgument, "the sigma %s is negative", names[k]);
  if (!(problem.sigma_strip_m > 0))
    fail(Status::kInvalidArgument, "the sigma of strips is 0: their conditions could not all hold");
  if (problem.x.size() != problem.y.size() || problem.x.size() < 2)
    fail(Status::kInvalidArgument, "the trajectory has %zu and %zu control positions",
         problem.x.size(), problem.y.size());
  if (!(problem.strip_correlation_m >= 0))
    fail(Status::kInvalidArgument, "the length over which strips hang together is negative");
  for (const double sigma : problem.sigma_attitude_rad)
    if (!(sigma >= 0))
      fail(Status::kInvalidArgument, "a sigma of the attitudes' constant error is negative");
  if (!problem.is_held.empty() && problem.is_held.size() != problem.facades)
    fail(Status::kInvalidArgument, "%zu facades are said to be held or not, of %u",
         problem.is_held.size(), problem.facades);
  for (size_t i = 0; i < problem.control_points.size(); ++i) {
    const ControlCondition& point = problem.control_points[i];
    if (!(point.sigma_m > 0) || point.shares.empty() ||
        point.shares.back().first >= problem.controls())
      fail(Status::kInvalidArgument,
           "control point %zu has no sigma, or is of a time that is not there", i);
  }
  if (problem.strips.empty())
    fail(Status::kInsufficientData, "no strip is matched: there is nothing to adjust");
  for (size_t s = 0; s < problem.strips.size(); ++s) {
    const StripCondition& strip = problem.strips[s];
    if (strip.block >= problem.blocks || strip.facade >= problem.facades || strip.shares.empty() ||
        strip.shares.back().first >= problem.controls())
      fail(Status::kInvalidArgument, "strip %zu is of a block, facade or time that is not there",
           s);
  }
}

}  // namespace jalon
