// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/network/network_system.h"

#include <doctest/doctest.h>

#include "base/error.h"
#include "registration/network/approximate.h"
#include "unit/registration/network/made_network.h"

using namespace jalon;
using namespace jalon::test;

namespace {

Survey noisy_survey(const NetworkSettings& settings) {
  RandomStream random(4, 3);
  Survey survey = observed(settings, {&random});
  place_points(survey, settings);
  return survey;
}

Eigen::MatrixXd normal_of(const NetworkProblem& problem, const NetworkLinearised& equations) {
  Eigen::MatrixXd n = Eigen::MatrixXd::Zero(problem.unknowns.count, problem.unknowns.count);
  for (const auto& group : equations.groups) {
    Eigen::MatrixXd a = Eigen::MatrixXd::Zero(group.weight.rows(), problem.unknowns.count);
    for (size_t i = 0; i < group.members.size(); ++i) {
      a.row(static_cast<Eigen::Index>(i)) = equations.rows[group.members[i]].dense(a.cols());
    }
    n += a.transpose() * group.weight * a;
  }
  return n;
}

}  // namespace

TEST_CASE("network_system__the_sparse_form_solves_what_the_dense_one_does") {
  const NetworkSettings settings;
  const Survey survey = noisy_survey(settings);
  const NetworkProblem problem(survey, settings);
  const NetworkLinearised equations(problem, problem.start());
  const NetworkSystem system(problem, equations);
  CHECK(system.defect() == 0);
  const Eigen::MatrixXd n = normal_of(problem, equations);
  const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(n.rows(), -1, 1);
  CHECK((system.solve(b) - n.llt().solve(b)).norm() < 1e-9 * n.llt().solve(b).norm());
}

TEST_CASE("network_system__a_free_step_keeps_centre_and_bearing_and_solves_the_normal_equations") {
  NetworkSettings settings;
  settings.datum = NetworkDatum::kFree;
  const Survey survey = noisy_survey(settings);
  const NetworkProblem problem(survey, settings);
  const NetworkLinearised equations(problem, problem.start());
  const NetworkSystem system(problem, equations);
  CHECK(system.defect() == 4);
  const Eigen::VectorXd dx = system.step();
  Vec3 shift;
  for (const auto& point : problem.unknowns.points)
    shift += Vec3{dx[point[0]], dx[point[1]], dx[point[2]]};
  CHECK(norm(shift) < 1e-9);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(problem.unknowns.count);
  for (const auto& group : equations.groups) {
    const Eigen::VectorXd weighted = group.weight * group.residual;
    for (size_t i = 0; i < group.members.size(); ++i) {
      right += equations.rows[group.members[i]].dense(right.size()) *
               weighted[static_cast<Eigen::Index>(i)];
    }
  }
  CHECK((normal_of(problem, equations) * dx - right).norm() < 1e-6 * right.norm());
}

TEST_CASE("network_system__without_distances_a_free_network_has_no_size_either") {
  NetworkSettings settings;
  settings.datum = NetworkDatum::kFree;
  Survey survey = noisy_survey(settings);
  for (SurveySight& sight : survey.sightings) sight.distance_m = NAN;
  const NetworkProblem problem(survey, settings);
  CHECK(NetworkSystem(problem, NetworkLinearised(problem, problem.start())).defect() == 5);
}

TEST_CASE("network_system__parts_that_no_sight_joins_are_refused") {
  NetworkSettings settings;
  settings.datum = NetworkDatum::kFree;
  Survey survey = noisy_survey(settings);
  std::erase_if(survey.sightings,
                [](const SurveySight& s) { return s.target == 7 || s.setup == 7; });
  const NetworkProblem problem(survey, settings);
  const NetworkLinearised equations(problem, problem.start());
  CHECK_THROWS_AS(NetworkSystem(problem, equations), Error);
}
