// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/solvers/set_back.h"

#include <doctest/doctest.h>

#include <cmath>
#include <cstdlib>
#include <functional>

#include "unit/registration/joint/joint_street.h"

using namespace jalon;

namespace {

// Least squares of six facades alone, z = -o_f >= 0: Q z + q is their pull, 0 of those that are free. Exchanged all
// at once, what is held comes back to where it was and so for ever.
struct SixFacades {
  static constexpr double kQ[6][6] = {{4.477, -5.200, -3.574, 2.189, -1.417, -2.623},
                                      {-5.200, 10.517, 5.858, -1.030, 3.537, 3.802},
                                      {-3.574, 5.858, 7.560, -2.363, 0.352, 3.832},
                                      {2.189, -1.030, -2.363, 2.874, -0.837, 1.203},
                                      {-1.417, 3.537, 0.352, -0.837, 3.608, -3.105},
                                      {-2.623, 3.802, 3.832, 1.203, -3.105, 10.905}};
  static constexpr double kq[6] = {-0.408, -0.849, -1.331, -0.4, -0.112, -0.725};
  int rounds = 0;

  JointSolution operator()(const JointProblem& problem, JointWanted) {
    ++rounds;
    REQUIRE(rounds < 100);
    Eigen::MatrixXd Q(6, 6);
    Eigen::VectorXd q(6);
    for (int i = 0; i < 6; ++i) {
      q[i] = kq[i];
      for (int j = 0; j < 6; ++j) Q(i, j) = kQ[i][j];
    }
    Eigen::MatrixXd free = Q;
    Eigen::VectorXd right = -q;
    for (int i = 0; i < 6; ++i)
      if (problem.is_held[static_cast<size_t>(i)]) {
        free.row(i).setZero(), free.col(i).setZero();
        free(i, i) = 1, right[i] = 0;
      }
    const Eigen::VectorXd z = free.ldlt().solve(right), w = Q * z + q;
    JointSolution made;
    for (int i = 0; i < 6; ++i) made.facades.push_back(-z[i]), made.facade_pulls.push_back(w[i]);
    return made;
  }
};

JointSolution by_form(const JointProblem& problem, JointWanted wanted) {
  return solve_reduced(problem, wanted);
}

// Errors of the street with walls that all stand behind their eaves.
JointErrors errors_behind(const JointProblem& problem, uint64_t seed) {
  JointErrors made = drawn_errors(joint_street(), problem, seed);
  // An error of the facade as given is in front of the wall: the adjusted offset is its opposite.
  for (double& f : made.model.facades) f = std::fabs(f);
  return made;
}

}  // namespace

TEST_CASE("solve_set_back__where_exchanging_all_at_once_goes_round__ends_at_the_least_sum") {
  JointProblem problem;
  problem.facades = 6;
  SixFacades solver;
  const JointSolution made = solve_set_back(problem, JointWanted::kValues, std::ref(solver));
  for (size_t f = 0; f < 6; ++f) {
    CHECK(made.facades[f] <= 1e-9);
    CHECK((problem.is_held[f] ? made.facade_pulls[f] >= 0 : made.facades[f] <= 1e-9));
  }
  CHECK(problem.is_held == std::vector<bool>{false, true, false, true, false, false});
  CHECK(std::fabs(made.facades[0] + 0.635) < 0.01);
  CHECK(solver.rounds > 10);  // those in vain, then one at a time
}

TEST_CASE("solve_set_back__of_any_draw__has_no_wall_before_its_eaves_and_the_least_square_sum") {
  const JointStreet& street = joint_street();
  JointProblem problem = street.problem(kJointScenarios[4]);
  const StripConditions perfect = street.perfect_conditions();
  problem.strips = perfect.conditions;
  for (uint64_t seed = 7001; seed <= 7010; ++seed) {
    set_distances(problem, drawn_errors(street, problem, seed), perfect.strip_of);
    const JointSolution made = solve_set_back(problem, JointWanted::kValues, by_form);
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
    const JointSolution either = by_form(problem, JointWanted::kSigmas),
                        behind = solve_set_back(problem, JointWanted::kSigmas, by_form);
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
