// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/solvers/whole_covariance.h"

#include <doctest/doctest.h>

#include <cmath>

#include "unit/registration/joint/joint_street.h"
#include "unit/registration/solvers/dense_form.h"

using namespace jalon;

namespace {

// Strips that hang together, a facade that is held, turns, a control point and noise of points.
JointProblem with_everything() {
  const JointStreet& street = joint_street();
  JointProblem problem = street.problem(kJointScenarios[4]);
  problem.strips = street.perfect_conditions().conditions;
  problem.sigma_attitude_rad = {0.009, 0, 0.004};
  problem.is_held.assign(problem.facades, false);
  problem.is_held[3] = true;
  problem.control_points.push_back({{{5, 0.25}, {6, 0.75}}, {0.1, -0.2}, 0.03});
  for (size_t s = 0; s < problem.strips.size(); ++s) {
    StripCondition& strip = problem.strips[s];
    strip.turns_m = {0.3 + 0.01 * static_cast<double>(s % 7), 0.1, 2.0};
    strip.place_m = 1.5 * static_cast<double>(s);
    strip.measured_variance_m2 = 1e-5 * static_cast<double>(1 + s % 3);
  }
  return problem;
}

double off(const JointProblem& problem) {
  const Eigen::MatrixXd reduced = solve_reduced(problem, JointWanted::kWhole).whole_covariance,
                        dense = solve_dense(problem).whole_covariance;
  REQUIRE(reduced.rows() == dense.rows());
  return (reduced - dense).cwiseAbs().maxCoeff();
}

}  // namespace

TEST_CASE("whole_covariance__of_everything_at_once__is_that_of_the_dense_form") {
  JointProblem problem = with_everything();
  CHECK(off(problem) < 1e-9);
  problem.strip_correlation_m = 3;
  CHECK(off(problem) < 1e-9);
}

TEST_CASE("whole_covariance__has_the_variances_of_all_sigmas_and_nothing_along_conditions") {
  JointProblem problem = with_everything();
  for (StripCondition& strip : problem.strips) strip.measured_variance_m2 = 0;
  const JointSolution made = solve_reduced(problem, JointWanted::kWhole);
  const Eigen::MatrixXd& C = made.whole_covariance;
  const JointOrder at = order_of(problem);
  const auto index = [](size_t i) { return static_cast<Eigen::Index>(i); };
  for (size_t f = 0; f < problem.facades; ++f)
    CHECK(std::fabs(std::sqrt(std::max(0.0, C(index(at.size() + f), index(at.size() + f)))) -
                    made.facades_sigmas[f]) < 1e-9);
  // A condition that holds exactly has no uncertainty: C b = 0.
  for (size_t s = 0; s < problem.strips.size(); s += 29) {
    const StripCondition& strip = problem.strips[s];
    Eigen::VectorXd b = Eigen::VectorXd::Zero(C.rows());
    for (const auto& [control, share] : strip.shares) {
      b[index(at.tx(control))] -= share * strip.normal.u;
      b[index(at.ty(control))] -= share * strip.normal.v;
    }
    b[index(at.dx(strip.block))] = strip.normal.u;
    b[index(at.dy(strip.block))] = strip.normal.v;
    for (size_t k = 0; k < at.turns; ++k) b[index(at.turn(k))] = strip.turns_m[k];
    b[index(at.size() + strip.facade)] = 1;
    b[index(at.size() + problem.facades + s)] = 1;
    CHECK((C * b).cwiseAbs().maxCoeff() < 1e-9);
  }
}
