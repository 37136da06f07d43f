// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Iterations of one level between two samples of a room, against the motion between them.

#include <doctest/doctest.h>

#include <cmath>

#include "registration/icp/iterations.h"
#include "unit/registration/icp_problems.h"
#include "unit/registration/registration_scenes.h"

using namespace jalon;
using namespace jalon::test;

namespace {

constexpr double kStart_m = 0.4;
const Transform kMoved = motion_about({3, 2, 1}, {0.01, -0.02, 0.03}, {0.1, -0.05, 0.04});

IcpProblem room_problem(const IcpSettings& settings = {}, const Transform& moved = kMoved,
                        size_t points = 1500) {
  return problem_between(scenes::sampled(scenes::room(), 1, {}, points),
                         scenes::sampled(scenes::room(), 2, moved, points), settings);
}

// The first row of the log, whatever comes then.
IcpIteration first_row(const IcpSettings& settings) {
  return iterated(room_problem(settings), {}, kStart_m).log.at(0);
}

}  // namespace

TEST_CASE("icp_iterate__converges_to_the_motion_between_two_samples") {
  const IcpProblem problem = room_problem({}, kMoved, 3000);
  const IcpState state = iterated(problem, {}, kStart_m);
  CHECK(state.stopped == StopReason::kConverged);
  const Transform off = problem.clouds.to_world(state.T_reference_moving) * kMoved;
  // Noise of 5 mm; some 500 points of either cloud hold each direction: 0.3 mm, and four times that.
  CHECK(norm(off.point({3, 2.5, 1}) - Vec3{3, 2.5, 1}) < 0.0012);
  // The last step is a tenth of what noise leaves open.
  CHECK(state.log.back().shift_m < 0.1 * 3 * 0.0003);
  CHECK(state.log.front().distance_m == kStart_m);
  CHECK(state.log.back().distance_m < kStart_m / 4);
  CHECK(state.log.back().kept > 0.9);
  CHECK(state.log.back().observable == 6);
  CHECK(state.log.back().rms_m < state.log.front().rms_m);
  CHECK(state.sigma_m ==
        doctest::Approx(0.005).scale(0).epsilon(0.2));  // of a point; planes add a little
  CHECK(state.has_all(problem));
}

TEST_CASE("icp_iterate__stops_after_the_steps_that_are_allowed") {
  Task task;
  for (const int most : {1, 3}) {
    const IcpProblem problem = room_problem({.max_iterations = most});
    IcpState state;
    state.T_reference_moving = problem.clouds.to_local({});
    state.distance_m = kStart_m;
    CHECK_FALSE(icp_iterate(problem, {}, state, task));
    CHECK(state.stopped == StopReason::kIterationLimit);
    CHECK(state.log.size() == static_cast<size_t>(most));
  }
}

TEST_CASE("icp_iterate__without_enough_in_common_stops_where_it_is") {
  const Transform away = motion_about({}, {}, {60, 0, 0});
  const IcpProblem apart = room_problem({}, away);
  const IcpState none = iterated(apart, {}, kStart_m);
  CHECK(none.stopped == StopReason::kTooFewPairs);
  CHECK(none.log.size() == 1);
  CHECK(none.T_reference_moving.m == apart.clouds.to_local({}).m);
  // Four fifths of a plane lie on the other one.
  const Transform beside = motion_about({}, {}, {2, 0, 0});
  const auto shifted_wall = [&](double min_overlap_percent) {
    IcpSettings settings;
    settings.min_overlap_percent = min_overlap_percent;
    const IcpProblem problem =
        problem_between(scenes::sampled(scenes::one_plane(), 3, {}, 1500),
                        scenes::sampled(scenes::one_plane(), 4, beside, 1500), settings);
    return iterated(problem, {}, 0.1);
  };
  CHECK(shifted_wall(95).stopped == StopReason::kTooFewPairs);
  const IcpState enough = shifted_wall(70);
  CHECK(enough.stopped == StopReason::kConverged);
  CHECK(enough.log.back().kept == doctest::Approx(0.8).scale(0).epsilon(0.05));
  CHECK(enough.log.back().observable == 3);
}

TEST_CASE("icp_iterate__trims_the_share_of_pairs_that_is_asked_for") {
  const IcpIteration whole = first_row({.kernel = KernelKind::kNone}),
                     trimmed = first_row({.kernel = KernelKind::kNone, .trim_percent = 30});
  // Up to the pairs at the quantile itself.
  CHECK(std::abs(static_cast<double>(trimmed.pairs) - 0.7 * static_cast<double>(whole.pairs)) <= 3);
  CHECK(trimmed.rms_m < whole.rms_m);
}
