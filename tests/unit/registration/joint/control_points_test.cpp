// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/joint/control_points.h"

#include <doctest/doctest.h>

#include <string>

#include "base/error.h"
#include "unit/registration/joint/joint_street.h"

using namespace jalon;

namespace {

const std::vector<double> kTimes{0, 1, 2, 3};

void refuses(const std::vector<double>& numbers, const char* words) {
  try {
    control_points(numbers, kTimes);
    FAIL("not refused");
  } catch (const Error& e) {
    CHECK(std::string(e.what()).find(words) != std::string::npos);
  }
}

}  // namespace

TEST_CASE("control_points__of_six_numbers_each__ask_for_a_correction_when_they_were_seen") {
  const auto made = control_points(std::vector<double>{1.25, 10, 20, 10.5, 19, 0.02}, kTimes);
  REQUIRE(made.size() == 1);
  CHECK(made[0].shares[0].first == 1);
  CHECK(made[0].shares[0].second == doctest::Approx(0.75));
  CHECK(made[0].shares[1].second == doctest::Approx(0.25));
  CHECK(made[0].correction_m.u == doctest::Approx(0.5));
  CHECK(made[0].correction_m.v == doctest::Approx(-1));
  CHECK(control_points({}, kTimes).empty());
}

TEST_CASE("control_points__that_are_wrong__are_refused_with_their_number") {
  refuses({1, 2, 3, 4, 5}, "has 5 numbers");
  refuses({1, 0, 0, 0, 0, 1, 9, 0, 0, 0, 0, 1}, "control point 1 was seen at 9 s");
  refuses({1, 0, 0, 0, 0, 0}, "control point 0 has a standard deviation of 0 m");
}

// A drive that is off by metres and a model that is as unsure: only control points say where both are.
TEST_CASE("control_points__of_a_street_nobody_is_sure_of__bring_drive_and_blocks_to_the_map") {
  const JointStreet& street = joint_street();
  JointProblem problem = street.problem({2, 0.05, 0.05, 2});
  const StripConditions perfect = street.perfect_conditions();
  problem.strips = perfect.conditions;
  const JointErrors errors = drawn_errors(street, problem, 7201);
  set_distances(problem, errors, perfect.strip_of);
  const auto rms = [&](const JointSolution& made) {
    double sum = 0;
    for (size_t c = 0; c < made.trajectory.size(); ++c)
      sum += std::pow(made.trajectory[c].u + errors.x[c], 2) +
             std::pow(made.trajectory[c].v + errors.y[c], 2);
    return std::sqrt(sum / (2 * static_cast<double>(made.trajectory.size())));
  };
  const JointSolution before = solve_reduced(problem, JointWanted::kSigmas);
  for (const uint32_t at : {5u, 25u, 48u})
    problem.control_points.push_back({{{at, 1.0}}, {-errors.x[at], -errors.y[at]}, 0.01});
  const JointSolution after = solve_reduced(problem, JointWanted::kSigmas);
  MESSAGE("FIGURE joint, three control points: trajectory ", rms(before), " m before, ", rms(after),
          " m after");
  CHECK(rms(after) < 0.1);
  CHECK(rms(after) < 0.2 * rms(before));
  CHECK(after.trajectory_sigmas[25].u < 0.0101);
  CHECK(after.trajectory_sigmas[25].u < before.trajectory_sigmas[25].u);
}
