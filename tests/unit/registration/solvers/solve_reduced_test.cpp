// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <cstdlib>

#include "base/error.h"
#include "registration/solvers/joint_residuals.h"
#include "unit/registration/solvers/joint_bands.h"
#include "unit/registration/joint/joint_street.h"
#include "unit/registration/solvers/dense_form.h"

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

// The truth of an observation in error by e is -e from it.
JointTruth truth_of(const JointErrors& e, const std::vector<uint32_t>& strip_of) {
  JointTruth truth;
  for (size_t c = 0; c < e.x.size(); ++c) truth.trajectory.push_back({-e.x[c], -e.y[c]});
  for (const Vec2& b : e.model.blocks) truth.blocks.push_back({-b.u, -b.v});
  for (const double f : e.model.facades) truth.facades.push_back(-f);
  for (const uint32_t s : strip_of) truth.strips.push_back(-e.model.strips[s]);
  return truth;
}

void are_standard_normal_over_draws(const JointStreet& street, const std::string& name,
                                    bool is_the_texts) {
  const int draws = std::getenv("JALON_FULL") != nullptr ? 2000 : 40;
  int number = 0;
  for (const JointScenario& scenario : kJointScenarios) {
    ++number;
    CAPTURE(number);
    JointProblem problem = street.problem(scenario);
    const StripConditions perfect = street.perfect_conditions();
    problem.strips = perfect.conditions;
    REQUIRE(problem.strips.size() > 290);
    std::vector<Residuals> groups(kJointGroups);
    OverDraws chi, whitened;
    OverDraws within;
    std::vector<DrawBands> bands(kJointGroups);
    std::array<DrawBands, kJointGroups> foretold;
    ErrorsLeft left;
    for (int draw = 0; draw < draws; ++draw) {
      const JointErrors e = drawn_errors(street, problem, 5000 + static_cast<uint64_t>(draw));
      set_distances(problem, e, perfect.strip_of);
      const bool foretells = draw == 0 && draws >= kDrawsOfBands;
      const JointSolution solution =
          solve_reduced(problem, foretells ? JointWanted::kWhole : JointWanted::kCovariance);
      const JointTruth truth = truth_of(e, perfect.strip_of);
      const auto z = normalised_residuals(solution, truth);
      left.add(solution, truth);
      if (foretells) foretold = foretold_bands(solution);
      double in = 0, all = 0;
      for (size_t g = 0; g < kJointGroups; ++g) {
        groups[g].add(z[g]);
        bands[g].add(z[g]);
        for (const double v : z[g]) in += std::fabs(v) <= 3 ? 1 : 0;
        all += static_cast<double>(z[g].size());
      }
      within.values.push_back(in / all);
      whitened.values.push_back(whitened_mean_square(solution, truth));
      chi.values.push_back(solution.chi_square / static_cast<double>(problem.strips.size()));
    }
    for (const Residuals& group : groups) group.are_standard_normal();
    CHECK(std::fabs(chi.mean() - 1) < 4 * chi.standard_error());
    CHECK(std::fabs(whitened.mean() - 1) < 4 * whitened.standard_error());
    constexpr double kWithin = 0.9973;  // of normal values, within 3 sigma
    CHECK(std::fabs(within.mean() - kWithin) < 4 * within.standard_error());
    MESSAGE("FIGURE joint, ", name, ", scenario ", number, ", ", draws,
            " draws: chi-square over strips ", chi.mean(), " +- ", chi.standard_error(),
            ", whitened ", whitened.mean(), " +- ", whitened.standard_error(),
            ", mean square of T x ", groups[kTrajectoryX].square.mean(), ", blocks x ",
            groups[kBlocksX].square.mean(), ", facades ", groups[kFacades].square.mean(),
            ", strips ", groups[kStrips].square.mean(), ", share within 3 sigma ", within.mean());
    if (draws < kDrawsOfBands) continue;
    for (size_t g = 0; g < kJointGroups; ++g) {
      MESSAGE("FIGURE joint, ", name, ", scenario ", number, ", ", draws, " draws, ",
              std::string(kJointGroupNames[g]),
              ": 95 % of |mean|; spreads; 95 % of max: ", bands[g].told(), ", foretold ",
              foretold[g].told(), " (worst ratio ", bands[g].worst_ratio(foretold[g]),
              "), street of 272 strips ",
              std::string(kStreetBands[static_cast<size_t>(number - 1)][g]));
      CHECK(bands[g].worst_ratio(foretold[g]) < 1.1);
    }
    MESSAGE("FIGURE joint, ", name, ", scenario ", number, ", ", draws, " draws, ", left.told());
    left.are_as_foretold();
    if (is_the_texts) left.check_reductions(number);
  }
}

}  // namespace

TEST_CASE("solve_reduced__of_five_scenarios__has_standard_normal_residuals_over_draws") {
  are_standard_normal_over_draws(joint_street(), "drawn street", false);
}

TEST_CASE("solve_reduced__of_the_texts_street__leaves_what_the_text_foretells") {
  are_standard_normal_over_draws(JointStreet(0), "street in turn", true);
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
      const JointSolution sparse = solve_reduced(problem, JointWanted::kWhole),
                          dense = solve_dense(problem);
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
      CHECK((sparse.whole_covariance - dense.whole_covariance).cwiseAbs().maxCoeff() /
                (size * size) <
            1e-9);
      CHECK(sparse.chi_square == doctest::Approx(dense.chi_square).epsilon(1e-6));
    }
}

// What is sure stays where it is, by the same form and at the same cost.
TEST_CASE("solve_reduced__with_sigmas_of_zero__equals_the_dense_form") {
  const JointStreet& street = joint_street();
  JointProblem problem = street.problem({0.01, 0.01, 0.01, 2});
  const StripConditions perfect = street.perfect_conditions();
  problem.strips = perfect.conditions;
  set_distances(problem, drawn_errors(street, problem, 78), perfect.strip_of);
  problem.sigma_block_x_m = problem.sigma_facade_m = 0;
  const JointSolution made = solve_reduced(problem, JointWanted::kWhole),
                      dense = solve_dense(problem);
  for (size_t b = 0; b < made.blocks.size(); ++b) {
    CHECK(made.blocks[b].u == 0);
    CHECK(made.blocks_sigmas[b].u == 0);
    CHECK(std::fabs(made.blocks[b].v - dense.blocks[b].v) < 1e-9);
  }
  for (const double f : made.facades) CHECK(f == 0);
  for (size_t c = 0; c < made.trajectory.size(); ++c)
    CHECK(norm(made.trajectory[c] - dense.trajectory[c]) < 1e-9);
  CHECK((made.whole_covariance - dense.whole_covariance).cwiseAbs().maxCoeff() < 1e-9);
  CHECK(std::fabs(made.chi_square / dense.chi_square - 1) < 1e-6);
  problem.sigma_strip_m = 0;
  CHECK_THROWS_AS(solve_reduced(problem, JointWanted::kSigmas), Error);
}
