// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "registration/joint/joint_problem.h"

namespace jalon {

/// The solution of a problem whose facades were digitised at their eaves, so that walls stand at them or behind, never
/// before: the least square sum with all o_f <= 0, by holding at 0 the facades that would come forward and letting go
/// those that their strips pull back (active set; Lawson & Hanson 1974, ch. 23). problem.is_held is what was held at
/// the end; solve: one of the two forms. Standard deviations are those without the bound, which are the greater: of a
/// normal distribution cut off at a bound less is left. O(rounds) solutions.
template <class Solve>
JointSolution solve_set_back(JointProblem& problem, Solve&& solve);

/// Holds and lets go by a solution. True where nothing changes: it is the one.
bool hold_facades(const JointSolution& solution, std::vector<bool>& is_held);

constexpr int kMostRounds =
    50;  ///< a round or two a facade at the edge; then what is held stays so

template <class Solve>
JointSolution solve_set_back(JointProblem& problem, Solve&& solve) {
  problem.is_held.assign(problem.facades, false);
  const JointSolution unbound = solve(problem);
  JointSolution made = unbound;
  for (int round = 0; round < kMostRounds && !hold_facades(made, problem.is_held); ++round)
    made = solve(problem);
  made.trajectory_sigmas = unbound.trajectory_sigmas, made.blocks_sigmas = unbound.blocks_sigmas;
  made.facades_sigmas = unbound.facades_sigmas, made.strips_sigmas = unbound.strips_sigmas;
  made.attitude_sigmas_rad = unbound.attitude_sigmas_rad;
  made.covariance = unbound.covariance;
  return made;
}

}  // namespace jalon
