// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "registration/solvers/joint_problem.h"

namespace jalon {

/// Which facades are held at their eaves: those that would come forward are held, those that their strips pull back are
/// let go, all at once for as long as ever fewer contradict, and after some rounds without that one at a time, which
/// ends (Judice & Pires 1994, block principal pivoting; Murty 1974).
class HeldFacades {
 public:
  explicit HeldFacades(size_t facades) : is_held_(facades, false), fewest_(facades + 1) {}

  /// By the solution with what is held now. False where nothing contradicts: it is the one.
  bool change(const JointSolution& solution);
  const std::vector<bool>& list() const { return is_held_; }

 private:
  std::vector<bool> is_held_;
  size_t fewest_;        ///< that contradicted so far
  int rounds_left_ = 0;  ///< of all at once, without fewer
};

/// The solution of a problem whose facades were digitised at their eaves, so that walls stand at them or behind, never
/// before: the least square sum with all o_f <= 0. problem.is_held is what was held at the end; solve(problem, wanted):
/// one of the two forms. Standard deviations are those without the bound, which are the greater: of a normal
/// distribution cut off at a bound less is left. A solution a round, a few rounds as a rule.
template <class Solve>
JointSolution solve_set_back(JointProblem& problem, JointWanted wanted, Solve&& solve) {
  HeldFacades held(problem.facades);
  problem.is_held = held.list();
  const JointSolution unbound = solve(problem, wanted);
  JointSolution made = unbound;
  while (held.change(made)) {
    problem.is_held = held.list();
    made = solve(problem, JointWanted::kValues);
  }
  made.trajectory_sigmas = unbound.trajectory_sigmas, made.blocks_sigmas = unbound.blocks_sigmas;
  made.facades_sigmas = unbound.facades_sigmas, made.strips_sigmas = unbound.strips_sigmas;
  made.attitude_sigmas_rad = unbound.attitude_sigmas_rad;
  made.covariance = unbound.covariance, made.whole_covariance = unbound.whole_covariance;
  return made;
}

}  // namespace jalon
