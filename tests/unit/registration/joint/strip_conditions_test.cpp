// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/joint/strip_conditions.h"

#include <doctest/doctest.h>

#include "unit/registration/joint/joint_street.h"

using namespace jalon;

TEST_CASE("strip_conditions__of_perfect_points__are_met_and_their_shares_sum_to_one") {
  const JointStreet& street = joint_street();
  const StripConditions made = strip_conditions(
      street.matches(street.cloud), street.given(street.strips), street.controls(), 1, 0.005);
  CHECK(made.conditions.size() > 290);  // those beside the start are not passed
  for (const StripCondition& c : made.conditions) {
    double sum = 0;
    for (const auto& [control, share] : c.shares) sum += share;
    CHECK(sum == doctest::Approx(1));
    CHECK(std::fabs(c.distance_m) < 1e-9);
    CHECK(c.measured_variance_m2 <= 0.005 * 0.005);
  }
  const StripConditions few = strip_conditions(
      street.matches(street.cloud), street.given(street.strips), street.controls(), 100, 0);
  CHECK(few.conditions.size() < made.conditions.size());
}

// The whole way: a wrong drive and a wrong model, points of that drive, the true matches.
TEST_CASE("strip_conditions__of_a_wrong_drive_and_model__lead_back_to_the_truth") {
  const JointStreet& street = joint_street();
  const JointScenario scenario = kJointScenarios[0];  // 2 m of trajectory, a good model
  JointProblem problem = street.problem(scenario);
  Trajectory wrong = interpolated(street.drive, street.controls());
  for (size_t i = 0; i < wrong.size(); ++i)
    wrong.position_sigmas_m[i] = Vec3{1, 1, 1} * scenario.trajectory,
    wrong.velocity_sigmas_m_s[i] = Vec3{1, 1, 1} * kDriftSigma_m_s;
  const Trajectory perturbed_controls = perturbed(wrong, 9);
  // The correction between control positions is linear: the drive at every epoch is moved by it.
  Trajectory moved = street.drive;
  std::vector<Vec2> errors;
  for (size_t i = 0; i < wrong.size(); ++i) {
    const Vec3 e = perturbed_controls.positions[i] - wrong.positions[i];
    errors.push_back({e.x, e.y});
  }
  for (size_t i = 0; i < moved.size(); ++i) {
    const TimePlace at = time_place(wrong.times_s, moved.times_s[i], i);
    const Vec2 e = errors[at.epoch] * (1 - at.share) + errors[at.epoch + 1] * at.share;
    moved.positions[i] += Vec3{e.u, e.v, 0};
  }
  const auto values = [&](const char* name) {
    return street.cloud.fields.require(name).values<double>();
  };
  Task task;
  const Cloud cloud =
      georeferenced(moved, {values("time"), values("range"), values("theta"), values("phi")},
                    street.scanner.mount, task);
  const BuildingOffsets model =
      drawn_offsets(street.strips, {scenario.block, scenario.facade, scenario.strip, 9});
  problem.strips =
      strip_conditions(street.matches(cloud), street.given(moved_strips(street.strips, model)),
                       street.controls(), 1, 0)
          .conditions;
  const JointSolution solution = solve_reduced(problem, JointWanted::kValues);
  double before = 0, after = 0;
  for (size_t c = 0; c < errors.size(); ++c) {
    before += dot(errors[c], errors[c]);
    const Vec2 left = solution.trajectory[c] + errors[c];
    after += dot(left, left);
  }
  const double n = static_cast<double>(2 * errors.size());
  MESSAGE("FIGURE joint, scenario 1, one draw from the cloud on: trajectory ",
          std::sqrt(before / n), " m before, ", std::sqrt(after / n), " m after");
  CHECK(std::sqrt(before / n) > 0.3);
  CHECK(std::sqrt(after / n) < 0.05);
}

TEST_CASE("weak_direction__of_walls_nearly_along_a_street__is_along_it") {
  std::vector<StripCondition> strips(4);
  for (size_t i = 0; i < strips.size(); ++i) {
    const double turn = i % 2 == 0 ? 0.1 : -0.1;
    strips[i].normal = {std::sin(turn), std::cos(turn)};
  }
  const WeakDirection along = weak_direction(strips);
  CHECK(std::fabs(along.direction.u) == doctest::Approx(1));
  CHECK(along.share == doctest::Approx(std::tan(0.1) * std::tan(0.1)).scale(0));
  for (StripCondition& strip : strips) strip.normal = {0, 1};
  CHECK(weak_direction(strips).share < 1e-15);
}
