// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/icp/confirm.h"

#include <doctest/doctest.h>

#include "accuracy/registration_pairs.h"
#include "unit/registration/icp_problems.h"
#include "unit/registration/registration_scenes.h"

using namespace jalon;
using namespace jalon::test;

namespace {

size_t open_directions(const IcpState& state) {
  const auto& observable = state.last.directions.observable;
  return static_cast<size_t>(std::count(observable.begin(), observable.end(), false));
}

double confirmed(const IcpProblem& problem, IcpState& state) {
  Task task;
  const IcpJudged judged =
      icp_judged(*problem.thinned_reference.cloud, *problem.thinned_moving.cloud, problem, 0, task);
  return icp_confirm(problem, judged, {}, state, task);
}

IcpProblem fronts(double off_m) {
  ScanSettings scanner;
  scanner.is_turned = false;
  scanner.noise_m = 0.010;
  const PairScene scene = front(3, 3);
  Task task;
  Transform away;
  away.m[3] = off_m;
  return problem_between(transformed(*scan_from(scene, 0, scanner, 31).cloud, {}, task),
                         transformed(*scan_from(scene, 2, scanner, 32).cloud, away, task));
}

}  // namespace

TEST_CASE("icp_confirm__takes_the_steps_again_in_directions_that_the_surfaces_hold") {
  const IcpProblem problem = fronts(0.02);
  IcpState state = iterated(problem, {}, 0.2);
  REQUIRE(open_directions(state) == 1);  // noise hides the reveals from the normals
  const size_t rows = state.log.size();
  CHECK(confirmed(problem, state) == 0);
  CHECK(open_directions(state) == 0);
  CHECK(state.log.size() > rows);
  const Vec3 shift = problem.clouds.to_world(state.T_reference_moving).translation();
  CHECK(std::abs(shift.x + 0.02) < 0.003);
}

TEST_CASE("icp_confirm__leaves_open_what_nothing_holds") {
  for (const scenes::Scene& scene : {scenes::corridor(), scenes::one_plane()}) {
    const IcpProblem problem =
        problem_between(scenes::sampled(scene, 5), scenes::sampled(scene, 6));
    IcpState state = iterated(problem, {}, 0.2);
    REQUIRE(open_directions(state) == scene.open_directions);
    const Transform before = state.T_reference_moving;
    CHECK(confirmed(problem, state) == 0);
    CHECK(open_directions(state) == scene.open_directions);
    CHECK(state.T_reference_moving.m == before.m);
  }
}

TEST_CASE("icp_confirm__says_where_else_both_agree_better") {
  const IcpProblem problem = fronts(1.5);
  IcpState state = iterated(problem, {}, 0.2);
  REQUIRE(open_directions(state) == 1);
  const double better_m = confirmed(problem, state);
  CHECK(std::abs(better_m + 1.5) < 0.45);  // two steps of the search, which windows alike may win
  CHECK(open_directions(state) == 1);
}
