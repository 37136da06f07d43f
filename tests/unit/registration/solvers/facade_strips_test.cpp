// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/solvers/facade_strips.h"

#include <doctest/doctest.h>

#include <cstdlib>

#include "base/random.h"
#include "unit/registration/joint/joint_street.h"
#include "unit/registration/solvers/dense_form.h"

using namespace jalon;

namespace {

constexpr double kReach_m = 4;  // between two and three strips

// The street with strips that hang together, what measures them 1 cm.
JointProblem hanging_together(StripConditions& perfect) {
  const JointStreet& street = joint_street();
  JointProblem problem = street.problem({0.2, 0.5, 0.3, 1});
  std::vector<GivenStrip> given = street.given(street.strips);
  for (size_t s = 0; s < given.size(); ++s) given[s].place_m = 1.5 * static_cast<double>(s);
  perfect = strip_conditions(street.matches(street.cloud), given, street.controls(), 1, 0);
  problem.strips = perfect.conditions;
  for (StripCondition& strip : problem.strips) strip.measured_variance_m2 = 1e-4;
  problem.strip_correlation_m = kReach_m;
  return problem;
}

// Offsets of strips drawn from their prior: a chain along each facade, whose strips stand at even places.
std::vector<double> drawn_strips(const JointProblem& problem, const std::vector<uint32_t>& strip_of,
                                 size_t strips, uint64_t seed) {
  std::vector<double> made(strips, 0);
  RandomStream random(seed, 21);
  for (size_t i = 0; i < problem.strips.size(); ++i) {
    const StripCondition& strip = problem.strips[i];
    const bool follows = i > 0 && problem.strips[i - 1].facade == strip.facade;
    const double rho = follows ? strip_correlation(problem, problem.strips[i - 1], strip) : 0;
    const double before = follows ? made[strip_of[i - 1]] : 0;
    made[strip_of[i]] =
        rho * before + problem.sigma_strip_m * std::sqrt(1 - rho * rho) * random.normal();
  }
  return made;
}

}  // namespace

TEST_CASE("facade_strips__that_hang_together__have_the_inverse_of_their_covariance") {
  StripConditions perfect;
  const JointProblem problem = hanging_together(perfect);
  for (const FacadeStrips& f : strips_by_facade(problem)) {
    if (f.strips.empty()) continue;
    const auto n = static_cast<Eigen::Index>(f.strips.size());
    Eigen::MatrixXd V = f.prior;
    V.array() += problem.sigma_facade_m * problem.sigma_facade_m;
    V.diagonal().array() += 1e-4;
    CHECK((V * f.inverse - Eigen::MatrixXd::Identity(n, n)).cwiseAbs().maxCoeff() < 1e-9);
  }
}

TEST_CASE("solve_reduced__of_strips_that_hang_together_and_control_points__equals_the_dense_form") {
  StripConditions perfect;
  JointProblem problem = hanging_together(perfect);
  set_distances(problem, drawn_errors(joint_street(), problem, 78), perfect.strip_of);
  problem.control_points = {{{{10, 0.25}, {11, 0.75}}, {0.8, -0.4}, 0.02},
                            {{{40, 1.0}}, {-0.3, 0.6}, 0.05}};
  problem.is_held.assign(problem.facades, false);
  problem.is_held[3] = true;
  const JointSolution sparse = solve_reduced(problem, JointWanted::kCovariance),
                      dense = solve_dense(problem);
  double worst = (sparse.covariance - dense.covariance).cwiseAbs().maxCoeff();
  const auto compare = [&](double a, double b) { worst = std::max(worst, std::fabs(a - b)); };
  for (size_t c = 0; c < sparse.trajectory.size(); ++c) {
    compare(sparse.trajectory[c].u, dense.trajectory[c].u);
    compare(sparse.trajectory[c].v, dense.trajectory[c].v);
    compare(sparse.trajectory_sigmas[c].v, dense.trajectory_sigmas[c].v);
  }
  for (size_t f = 0; f < sparse.facades.size(); ++f) {
    compare(sparse.facades[f], dense.facades[f]);
    compare(sparse.facades_sigmas[f], dense.facades_sigmas[f]);
    compare(sparse.facade_pulls[f], dense.facade_pulls[f]);
  }
  for (size_t s = 0; s < sparse.strips.size(); ++s) {
    compare(sparse.strips[s], dense.strips[s]);
    compare(sparse.strips_sigmas[s], dense.strips_sigmas[s]);
  }
  CHECK(worst < 1e-9);
  CHECK(sparse.facades[3] == 0);
  CHECK(sparse.chi_square == doctest::Approx(dense.chi_square).epsilon(1e-6));
}

// Told that strips hang together, the same draws leave less error, and sigmas are what the errors are.
TEST_CASE(
    "facade_strips__drawn_as_they_hang_together__are_better_known_by_it_and_as_sure_as_told") {
  const int draws = std::getenv("JALON_FULL") != nullptr ? 400 : 20;
  StripConditions perfect;
  JointProblem problem = hanging_together(perfect);
  double squares = 0, squares_apart = 0, whitened = 0, chi = 0, n = 0;
  for (int draw = 0; draw < draws; ++draw) {
    const auto seed = 6000 + static_cast<uint64_t>(draw);
    JointErrors errors = drawn_errors(joint_street(), problem, seed);
    errors.model.strips = drawn_strips(problem, perfect.strip_of, errors.model.strips.size(), seed);
    set_distances(problem, errors, perfect.strip_of);
    RandomStream noise(seed, 22);
    for (StripCondition& strip : problem.strips) strip.distance_m += 0.01 * noise.normal();
    const JointSolution told = solve_reduced(problem, JointWanted::kSigmas);
    JointProblem apart = problem;
    apart.strip_correlation_m = 0;
    const JointSolution untold = solve_reduced(apart, JointWanted::kValues);
    chi += told.chi_square / static_cast<double>(problem.strips.size());
    for (size_t i = 0; i < problem.strips.size(); ++i) {
      const double truth = errors.model.strips[perfect.strip_of[i]];
      const double e = told.strips[i] + truth, e_apart = untold.strips[i] + truth;
      squares += e * e, squares_apart += e_apart * e_apart, n += 1;
      whitened += e * e / (told.strips_sigmas[i] * told.strips_sigmas[i]);
    }
  }
  MESSAGE("FIGURE joint, strips that hang together, ", draws, " draws: RMS of strips ",
          std::sqrt(squares / n), " m, taken for apart ", std::sqrt(squares_apart / n),
          ", mean square over sigmas ", whitened / n, ", chi-square over strips ", chi / draws);
  CHECK(squares < squares_apart);
  CHECK(whitened / n == doctest::Approx(1).epsilon(0.1));
  CHECK(chi / draws == doctest::Approx(1).epsilon(0.05));
}
