// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// The last steps on patches: when they are taken, and where they end.

#include <doctest/doctest.h>

#include <cmath>

#include "registration/icp/settle.h"
#include "unit/registration/icp_problems.h"
#include "unit/registration/registration_scenes.h"

using namespace jalon;
using namespace jalon::test;

namespace {

IcpProblem twice(const scenes::Scene& scene, size_t points, const IcpSettings& settings = {}) {
  const Transform moved = motion_about({3, 2, 1}, {0.003, -0.002, 0.004}, {0.02, -0.01, 0.015});
  return problem_between(scenes::sampled(scene, 11, {}, points),
                         scenes::sampled(scene, 12, moved, points), settings);
}

// Whether nothing at all has changed.
bool is_left_alone(const IcpProblem& problem, IcpState state) {
  const Transform before = state.T_reference_moving;
  const size_t rows = state.log.size();
  Task task;
  icp_settle(problem, state, task);
  return state.T_reference_moving.m == before.m && state.log.size() == rows &&
         state.patches.patches == 0;
}

}  // namespace

TEST_CASE("icp_settle__ends_where_the_patches_ask_for_no_further_step") {
  const IcpProblem problem = twice(scenes::room(), 2000);
  IcpState state = iterated(problem, {}, 0.2);
  REQUIRE(state.stopped == StopReason::kConverged);
  const Transform by_pairs = state.T_reference_moving;
  const size_t rows = state.log.size();
  const uint64_t pairs = state.last.sums.pairs;
  Task task;
  icp_settle(problem, state, task);
  REQUIRE(state.patches.patches > 10);
  CHECK(state.log.size() > rows);
  CHECK(state.last.sums.pairs == pairs);
  const Transform moved = state.T_reference_moving * inverse(by_pairs);
  const Vec3 centre = problem.frame(by_pairs).centre;
  CHECK(norm(moved.point(centre) - centre) < state.sigma_m);
  Cholesky<6> factor;
  REQUIRE(factor.factor(state.patches.normal));
  const Coefficients<6> step = factor.solve(state.patches.right);
  double squared = 0;
  for (size_t i = 0; i < 6; ++i) squared += step[i] * state.patches.right[i];
  // A tenth of a standard deviation of the pose, in noises of the points.
  CHECK(std::sqrt(squared * state.patches.weights / state.patches.squares) < 0.1);
  CHECK(state.patches.of_moving < state.patches.points);
}

TEST_CASE("icp_settle__is_for_converged_poses_of_robust_point_to_plane_alone") {
  const scenes::Scene corner = scenes::street_corner();
  const IcpProblem robust = twice(corner, 900);
  CHECK_FALSE(is_left_alone(robust, iterated(robust, {}, 0.2)));
  IcpState stopped = iterated(robust, {}, 0.2);
  stopped.stopped = StopReason::kIterationLimit;
  CHECK(is_left_alone(robust, std::move(stopped)));
  for (const IcpSettings& settings :
       {IcpSettings{.kernel = KernelKind::kNone}, IcpSettings{.trim_percent = 10},
        IcpSettings{.metric = IcpMetric::kPlaneToPlane}}) {
    const IcpProblem problem = twice(corner, 900, settings);
    CHECK(is_left_alone(problem, iterated(problem, {}, 0.2)));
  }
  // Nothing that pairs fixed: no direction to settle in.
  IcpState open = iterated(robust, {}, 0.2);
  open.last.directions.observable.fill(false);
  CHECK(is_left_alone(robust, std::move(open)));
}

TEST_CASE("patch_covariance__is_that_of_the_observable_directions_and_0_in_the_others") {
  PatchSums sums;
  IcpDirections directions;
  for (size_t k = 0; k < 6; ++k) {
    const auto held = static_cast<double>(k + 1);
    sums.normal[7 * k] = held;
    sums.scatter[7 * k] = 12;
    directions.unit[k][k] = 1;
    directions.observable[k] = k != 2;
  }
  const Square<6> found = patch_covariance(sums, directions);
  for (size_t r = 0; r < 6; ++r)
    for (size_t c = 0; c < 6; ++c) {
      const double n = static_cast<double>(r + 1);
      CHECK(found[6 * r + c] == doctest::Approx(r == c && r != 2 ? 12 / (n * n) : 0));
    }
  directions.observable.fill(false);
  CHECK(patch_covariance(sums, directions) == Square<6>{});
}
