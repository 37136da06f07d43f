// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/joint/set_back.h"

#include <doctest/doctest.h>

#include <cstdlib>

#include "unit/registration/joint/joint_street.h"

using namespace jalon;

namespace {

JointSolution by_sigmas(const JointProblem& problem) {
  return solve_reduced(problem, JointWanted::kSigmas);
}

// Errors of the street with walls that all stand behind their eaves.
JointErrors errors_behind(const JointProblem& problem, uint64_t seed) {
  JointErrors made = drawn_errors(joint_street(), problem, seed);
  // An error of the facade as given is in front of the wall: the adjusted offset is its opposite.
  for (double& f : made.model.facades) f = std::fabs(f);
  return made;
}

}  // namespace

TEST_CASE("solve_set_back__of_any_draw__has_no_wall_before_its_eaves_and_the_least_square_sum") {
  const JointStreet& street = joint_street();
  JointProblem problem = street.problem(kJointScenarios[4]);
  const StripConditions perfect = street.perfect_conditions();
  problem.strips = perfect.conditions;
  for (uint64_t seed = 7001; seed <= 7010; ++seed) {
    set_distances(problem, drawn_errors(street, problem, seed), perfect.strip_of);
    const JointSolution made = solve_set_back(problem, by_sigmas);
    size_t held = 0;
    for (size_t f = 0; f < made.facades.size(); ++f) {
      CHECK(made.facades[f] <= 1e-9);
      held += problem.is_held[f] ? 1 : 0;
      // The conditions of a least sum (Karush, Kuhn & Tucker): what is held is pulled forward.
      if (problem.is_held[f]) CHECK(made.facade_pulls[f] >= 0);
    }
    CHECK(held > 5);
    CHECK(held < made.facades.size());
  }
}

TEST_CASE(
    "solve_set_back__of_walls_behind_their_eaves__leaves_less_error_and_sigmas_that_cover_it") {
  const int draws = std::getenv("JALON_FULL") != nullptr ? 400 : 20;
  const JointStreet& street = joint_street();
  JointProblem problem = street.problem(kJointScenarios[4]);
  const StripConditions perfect = street.perfect_conditions();
  problem.strips = perfect.conditions;
  double bound = 0, unbound = 0, within = 0, n = 0;
  for (int draw = 0; draw < draws; ++draw) {
    const JointErrors errors = errors_behind(problem, 7100 + static_cast<uint64_t>(draw));
    set_distances(problem, errors, perfect.strip_of);
    problem.is_held.clear();
    const JointSolution either = by_sigmas(problem), behind = solve_set_back(problem, by_sigmas);
    for (size_t f = 0; f < errors.model.facades.size(); ++f) {
      const double e = behind.facades[f] + errors.model.facades[f],
                   e_either = either.facades[f] + errors.model.facades[f];
      bound += e * e, unbound += e_either * e_either, n += 1;
      within += std::fabs(e) <= 1.96 * behind.facades_sigmas[f] ? 1 : 0;
    }
  }
  MESSAGE("FIGURE joint, walls behind their eaves, ", draws, " draws: RMS of facades ",
          std::sqrt(bound / n), " m, on either side ", std::sqrt(unbound / n),
          "; within 1.96 sigma ", within / n);
  CHECK(bound < unbound);
  CHECK(within / n >= 0.93);
}
