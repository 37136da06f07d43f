// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "unit/registration/solvers/dense_form.h"

#include <doctest/doctest.h>

using namespace jalon;

namespace {

// Two control positions that move as one by 1 m at most, one block, one facade, one strip towards x.
JointProblem one_strip(double trajectory_m, double block_m, double facade_m, double strip_m) {
  const double times[] = {0, 1}, sigmas[] = {trajectory_m, trajectory_m}, slow[] = {1e-6, 1e-6};
  JointProblem made;
  made.x = made.y = gauss_markov(times, sigmas, slow);
  made.blocks = made.facades = 1;
  made.sigma_block_x_m = made.sigma_block_y_m = block_m;
  made.sigma_facade_m = facade_m, made.sigma_strip_m = strip_m;
  made.strips = {{0, 0, {1, 0}, {{0, 0.5}, {1, 0.5}}, 0.6, 0}};
  return made;
}

}  // namespace

// The distance is shared out by the variances: 0.6 m over 4 + 1 + 0.5 + 0.5.
TEST_CASE("solve_reduced__of_one_strip__shares_its_distance_by_the_variances") {
  const JointProblem problem = one_strip(2, 1, std::sqrt(0.5), std::sqrt(0.5));
  for (const JointSolution& made :
       {solve_reduced(problem, JointWanted::kSigmas), solve_dense(problem)}) {
    CHECK(made.trajectory[0].u == doctest::Approx(0.4));
    CHECK(made.trajectory[1].u == doctest::Approx(0.4));
    CHECK(made.blocks[0].u == doctest::Approx(-0.1));
    CHECK(made.facades[0] == doctest::Approx(-0.05));
    CHECK(made.strips[0] == doctest::Approx(-0.05));
    CHECK(made.chi_square == doctest::Approx(0.36 / 6));
    // Nothing is known across the normal: prior values and sigmas stay.
    CHECK(made.trajectory[0].v == 0);
    CHECK(made.blocks_sigmas[0].v == doctest::Approx(1));
    CHECK(made.blocks_sigmas[0].u == doctest::Approx(std::sqrt(1 - 1.0 / 6)));
  }
}

TEST_CASE("solve_reduced__with_a_sure_model_or_a_sure_drive__moves_the_other_alone") {
  const JointSolution located = solve_reduced(one_strip(2, 0, 0, 1e-4), JointWanted::kSigmas);
  CHECK(located.trajectory[0].u == doctest::Approx(0.6));
  CHECK(located.blocks[0].u == 0);
  CHECK(located.blocks_sigmas[0].u == 0);
  CHECK(located.facades_sigmas[0] == 0);
  const JointSolution updated = solve_reduced(one_strip(1e-4, 1, 0, 1e-4), JointWanted::kSigmas);
  CHECK(updated.blocks[0].u == doctest::Approx(-0.6));
  CHECK(std::fabs(updated.trajectory[0].u) < 1e-4);
}
