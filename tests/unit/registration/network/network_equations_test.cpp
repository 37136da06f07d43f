// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/network/network_equations.h"

#include <doctest/doctest.h>

#include "registration/network/approximate.h"
#include "unit/registration/network/made_network.h"

using namespace jalon;
using namespace jalon::test;

namespace {

Survey placed_survey(const NetworkSettings& settings) {
  Survey survey = observed(settings, {});
  survey.points[8].sigma_m = {0.01, 0.01, NAN};
  place_points(survey, settings);
  return survey;
}

}  // namespace

TEST_CASE("network_equations__every_row_is_the_slope_of_its_residual") {
  const NetworkSettings settings;
  const Survey survey = placed_survey(settings);
  const NetworkProblem problem(survey, settings);
  Eigen::VectorXd x = problem.start();
  for (Eigen::Index i = 0; i < x.size(); ++i) x[i] += 0.003 * static_cast<double>(i % 5);
  SparseRow row, unused;
  constexpr double kStep = 1e-4;
  for (const NetworkObservation& o : problem.observations) {
    problem.residual(o, x, row);
    const Eigen::VectorXd slopes = row.dense(x.size());
    for (size_t k = 0; k < row.count; ++k) {
      const int u = row.entries[k].first;
      Eigen::VectorXd low = x, high = x;
      low[u] -= kStep, high[u] += kStep;
      const double slope =
          (problem.residual(o, low, unused) - problem.residual(o, high, unused)) / (2 * kStep);
      CHECK(slopes[u] == doctest::Approx(slope).epsilon(1e-5).scale(1e-2));
    }
  }
}

TEST_CASE("network_equations__fixed_coordinates_are_no_unknowns_and_weak_ones_are_observed") {
  NetworkSettings settings;
  const Survey survey = placed_survey(settings);
  const NetworkProblem problem(survey, settings);
  CHECK(problem.unknowns.points[0] == std::array<int, 3>{kNoUnknown, kNoUnknown, kNoUnknown});
  CHECK(problem.unknowns.count == 3 * 10 + 12 + 3 * 12);
  const auto of_kind = [](const NetworkProblem& p, ObservationKind kind) {
    return std::count_if(p.observations.begin(), p.observations.end(),
                         [&](const NetworkObservation& o) { return o.kind == kind; });
  };
  CHECK(of_kind(problem, ObservationKind::kX) == 1);
  CHECK(of_kind(problem, ObservationKind::kZ) == 0);
  CHECK(of_kind(problem, ObservationKind::kCentring) == 24);
  settings.datum = NetworkDatum::kFree;
  settings.sigma_centring_m = settings.sigma_height_m = 0;
  const NetworkProblem open(survey, settings);
  CHECK(open.unknowns.count == 3 * 12 + 12);
  CHECK(of_kind(open, ObservationKind::kX) + of_kind(open, ObservationKind::kCentring) == 0);
}

TEST_CASE(
    "network_equations__sights_of_one_target_have_to_do_with_each_other_through_its_standing") {
  NetworkSettings settings;
  const Survey survey = placed_survey(settings);
  const NetworkProblem problem(survey, settings);
  const ObservationGroup& group = problem.groups.front();
  REQUIRE(group.members.size() == 3);
  const Eigen::MatrixXd c = problem.covariance(group, problem.start());
  CHECK(c(0, 0) > settings.sigma_direction_rad * settings.sigma_direction_rad);
  CHECK(c(2, 1) != 0);  // a higher target is a smaller zenith angle and another distance
  CHECK((c - c.transpose()).norm() == 0);
  settings.sigma_target_centring_m = settings.sigma_target_height_m = 0;
  const NetworkProblem sure(survey, settings);
  CHECK(sure.covariance(group, sure.start())(2, 1) == 0);
}
