// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// The result of ICP against the state of the iterations that it describes.

#include <doctest/doctest.h>

#include <cmath>

#include "registration/icp/result.h"
#include "unit/registration/icp_problems.h"
#include "unit/registration/registration_scenes.h"

using namespace jalon;
using namespace jalon::test;

namespace {

const Vec3 kTown{652000, 6861000, 35};

// Two samples of a corner of a street on a national grid; its points stand in larger clouds from here on.
constexpr uint32_t kBefore = 5000;

IcpProblem corner_problem(const Transform& moved = {}, const IcpSettings& settings = {}) {
  const auto sample = [](uint64_t seed, const Transform& by) {
    return scenes::sampled(scenes::street_corner(), seed, motion_about({}, {}, kTown) * by, 1500);
  };
  IcpProblem out = problem_between(sample(1, {}), sample(2, moved), settings);
  for (ThinnedCloud* thinned : {&out.thinned_reference, &out.thinned_moving})
    for (uint32_t i = 0; i < thinned->cloud->size(); ++i) thinned->index.push_back(kBefore + i);
  return out;
}

double of_summary(const Registration& r, const char* name) {
  return r.summary.require(name).number(0);
}

}  // namespace

TEST_CASE("icp_result__is_in_the_callers_coordinates_with_a_row_an_iteration") {
  const IcpProblem problem = corner_problem();
  const IcpState state = iterated(problem, {}, 0.3);
  REQUIRE(state.stopped == StopReason::kConverged);
  Task task;
  const Registration r = icp_result(problem, state, task);
  CHECK(r.converged);
  CHECK(r.iterations == state.log.size());
  CHECK(r.iteration_log.require("pairs").count() == state.log.size());
  CHECK(r.iteration_log.require("distance").number(0) == 0.3);
  CHECK(r.rms_m == state.log.back().rms_m);
  CHECK(of_summary(r, "kept") == state.log.back().kept);
  CHECK(of_summary(r, "sigma") == state.sigma_m);
  CHECK(of_summary(r, "patches") == 0);
  // The true pose is the identity; noise of 5 mm, hundreds of points a wall.
  CHECK(norm(r.pose.point(r.centre) - r.centre) < 0.005);
  CHECK(norm(r.centre - kTown - Vec3{7, 7, 2}) < 3);  // the middle of a corner of 14 x 14 x 7 m
  CHECK(r.unobservable == 0);
  for (size_t i = 0; i < 6; ++i) CHECK(r.covariance[7 * i] > 0);
}

TEST_CASE("icp_result__residuals_are_heights_of_raw_points_over_their_partners_planes") {
  const IcpProblem problem = corner_problem();
  const IcpState state = iterated(problem, {}, 0.3);
  Task task;
  const Registration r = icp_result(problem, state, task);
  const size_t rows = r.residuals.require("residual").count();
  CHECK(rows > 1200);
  const Cloud &reference = *problem.thinned_reference.cloud,
              &moving = *problem.thinned_moving.cloud;
  double weights = 0;
  for (size_t i = 0; i < rows; ++i) {
    const auto m = static_cast<uint32_t>(r.residuals.require("moving").number(i)) - kBefore;
    const auto p = static_cast<uint32_t>(r.residuals.require("reference").number(i)) - kBefore;
    REQUIRE(m < moving.size());
    REQUIRE(p < reference.size());
    const SurfacePlanes& planes = problem.clouds.reference;
    const SurfacePlane& plane = planes.planes[position_in(*planes.tree, p)];
    const double height = dot(plane.unit(), r.pose.point(moving.point(m)) - reference.point(p)) -
                          double{plane.height_m};
    // Coordinates of seven digits, grids and floats.
    CHECK(std::abs(height - r.residuals.require("residual").number(i)) < 2e-7);
    weights += r.residuals.require("weight").number(i);
  }
  CHECK(weights > 0.8 * static_cast<double>(rows));  // normal noise keeps 0.87 of the biweight
  CHECK(weights < static_cast<double>(rows));
}

TEST_CASE("icp_result__of_too_few_pairs_claims_nothing") {
  const IcpProblem problem = corner_problem(motion_about({}, {}, {80, 0, 0}));
  const IcpState state = iterated(problem, {}, 0.3);
  REQUIRE(state.stopped == StopReason::kTooFewPairs);
  Task task;
  const Registration r = icp_result(problem, state, task);
  CHECK_FALSE(r.converged);
  CHECK(r.stopped == StopReason::kTooFewPairs);
  CHECK(r.unobservable == 6);
  for (const double c : r.covariance) CHECK(std::isnan(c));
  CHECK(r.residuals.require("residual").count() == 0);
  CHECK(r.summary.find("sigma0") == nullptr);
  CHECK(norm(r.pose.point(kTown) - kTown) < 2e-8);  // the start, as it was
}
