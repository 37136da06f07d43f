// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <cstdlib>

#include "base/error.h"
#include "unit/registration/joint/joint_street.h"

using namespace jalon;

namespace {

// One value a draw: means over draws have the standard error of draws as units, however much the
// values of one draw hang together.
struct OverDraws {
  std::vector<double> values;
  double mean() const {
    double sum = 0;
    for (const double v : values) sum += v;
    return sum / static_cast<double>(values.size());
  }
  double standard_error() const {
    double sum = 0;
    for (const double v : values) sum += (v - mean()) * (v - mean());
    const double n = static_cast<double>(values.size());
    return std::sqrt(sum / (n - 1) / n);
  }
};

struct Residuals {
  OverDraws mean, square;
  void add(const std::vector<double>& z) {
    double sum = 0, sum2 = 0;
    for (const double v : z) sum += v, sum2 += v * v;
    mean.values.push_back(sum / static_cast<double>(z.size()));
    square.values.push_back(sum2 / static_cast<double>(z.size()));
  }
  void are_standard_normal() const {
    CHECK(std::fabs(mean.mean()) < 4 * mean.standard_error() + 1e-12);
    CHECK(std::fabs(square.mean() - 1) < 4 * square.standard_error());
  }
};

// (adjusted - true) / sigma, for each group: the truth of an observation in error by e is -e from it.
std::vector<std::vector<double>> normalised(const JointSolution& s, const JointErrors& e,
                                            const std::vector<uint32_t>& strip_of) {
  std::vector<std::vector<double>> z(6);
  for (size_t c = 0; c < e.x.size(); ++c) {
    z[0].push_back((s.trajectory[c].u + e.x[c]) / s.trajectory_sigmas[c].u);
    z[1].push_back((s.trajectory[c].v + e.y[c]) / s.trajectory_sigmas[c].v);
  }
  for (size_t b = 0; b < s.blocks.size(); ++b) {
    z[2].push_back((s.blocks[b].u + e.model.blocks[b].u) / s.blocks_sigmas[b].u);
    z[3].push_back((s.blocks[b].v + e.model.blocks[b].v) / s.blocks_sigmas[b].v);
  }
  for (size_t f = 0; f < s.facades.size(); ++f)
    z[4].push_back((s.facades[f] + e.model.facades[f]) / s.facades_sigmas[f]);
  for (size_t i = 0; i < s.strips.size(); ++i)
    z[5].push_back((s.strips[i] + e.model.strips[strip_of[i]]) / s.strips_sigmas[i]);
  return z;
}

}  // namespace

TEST_CASE("solve_reduced__of_five_scenarios__has_standard_normal_residuals_over_draws") {
  const JointStreet& street = joint_street();
  const int draws = std::getenv("JALON_FULL") != nullptr ? 2000 : 40;
  int number = 0;
  for (const JointScenario& scenario : kJointScenarios) {
    ++number;
    CAPTURE(number);
    JointProblem problem = street.problem(scenario);
    const StripConditions perfect = street.perfect_conditions();
    problem.strips = perfect.conditions;
    REQUIRE(problem.strips.size() > 290);
    std::vector<Residuals> groups(6);
    OverDraws chi;
    for (int draw = 0; draw < draws; ++draw) {
      const JointErrors e = drawn_errors(street, problem, 5000 + static_cast<uint64_t>(draw));
      set_distances(problem, e, perfect.strip_of);
      const JointSolution solution = solve_reduced(problem, false);
      const auto z = normalised(solution, e, perfect.strip_of);
      for (size_t g = 0; g < 6; ++g) groups[g].add(z[g]);
      chi.values.push_back(solution.chi_square / static_cast<double>(problem.strips.size()));
    }
    for (const Residuals& group : groups) group.are_standard_normal();
    CHECK(std::fabs(chi.mean() - 1) < 4 * chi.standard_error());
    MESSAGE("FIGURE joint, scenario ", number, ", ", draws, " draws: chi-square over strips ",
            chi.mean(), " +- ", chi.standard_error(), ", mean square of T x ",
            groups[0].square.mean(), ", blocks x ", groups[2].square.mean(), ", facades ",
            groups[4].square.mean(), ", strips ", groups[5].square.mean());
  }
}

TEST_CASE("solve_reduced__of_five_scenarios__equals_the_dense_form") {
  const JointStreet& street = joint_street();
  for (const JointScenario& scenario : kJointScenarios)
    for (const double noise : {0.0, 1e-4}) {
      JointProblem problem = street.problem(scenario);
      const StripConditions perfect = street.perfect_conditions();
      problem.strips = perfect.conditions;
      for (StripCondition& strip : problem.strips) strip.measured_variance_m2 = noise;
      set_distances(problem, drawn_errors(street, problem, 77), perfect.strip_of);
      const JointSolution sparse = solve_reduced(problem, true), dense = solve_dense(problem);
      const double size =
          std::max({scenario.block, scenario.facade, scenario.strip, scenario.trajectory});
      double worst = 0;
      const auto compare = [&](double a, double b) {
        worst = std::max(worst, std::fabs(a - b) / size);
      };
      for (size_t c = 0; c < sparse.trajectory.size(); ++c) {
        compare(sparse.trajectory[c].u, dense.trajectory[c].u);
        compare(sparse.trajectory[c].v, dense.trajectory[c].v);
        compare(sparse.trajectory_sigmas[c].u, dense.trajectory_sigmas[c].u);
      }
      for (size_t b = 0; b < sparse.blocks.size(); ++b) {
        compare(sparse.blocks[b].u, dense.blocks[b].u);
        compare(sparse.blocks_sigmas[b].v, dense.blocks_sigmas[b].v);
      }
      for (size_t f = 0; f < sparse.facades.size(); ++f) {
        compare(sparse.facades[f], dense.facades[f]);
        compare(sparse.facades_sigmas[f], dense.facades_sigmas[f]);
      }
      for (size_t s = 0; s < sparse.strips.size(); ++s) {
        compare(sparse.strips[s], dense.strips[s]);
        compare(sparse.strips_sigmas[s], dense.strips_sigmas[s]);
      }
      MESSAGE("FIGURE joint, reduced against dense: ", worst, " of the largest sigma");
      CHECK(worst < 1e-9);
      CHECK((sparse.covariance - dense.covariance).cwiseAbs().maxCoeff() / (size * size) < 1e-9);
      CHECK(sparse.chi_square == doctest::Approx(dense.chi_square).epsilon(1e-6));
    }
}

TEST_CASE("solve_reduced__with_sigmas_of_zero__is_refused_and_the_dense_form_takes_them") {
  const JointStreet& street = joint_street();
  JointProblem problem = street.problem({0.01, 0.01, 0.01, 2});
  problem.strips = street.perfect_conditions().conditions;
  problem.sigma_block_x_m = problem.sigma_block_y_m = 0;
  CHECK_THROWS_AS(solve_reduced(problem, false), Error);
  const JointSolution made = solve_dense(problem);
  for (const Vec2& b : made.blocks) CHECK(norm(b) == 0);
  problem.sigma_strip_m = 0;
  CHECK_THROWS_AS(solve_dense(problem), Error);
}
