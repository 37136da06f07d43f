// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// The covariance of a pose of pairs, at the true pose, against what the noise of the points allows.

#include <doctest/doctest.h>

#include <cmath>

#include "registration/icp/covariance.h"
#include "unit/registration/icp_problems.h"
#include "unit/registration/registration_scenes.h"

using namespace jalon;
using namespace jalon::test;

namespace {

constexpr double kNoise_m = 0.004;

// Three sheets of as many points each, one across each axis.
scenes::Scene three_sheets() {
  return {"three sheets",
          {{{1, 1, 0}, {4, 0, 0}, {0, 4, 0}},
           {{0, 1, 1}, {0, 4, 0}, {0, 0, 4}},
           {{1, 0, 1}, {4, 0, 0}, {0, 0, 4}}},
          kNoise_m,
          1800};
}

// Two samples of a scene, laid on each other as they truly lie.
struct Covered {
  IcpProblem problem;
  IcpCovariance found;

  explicit Covered(const scenes::Scene& scene, double scale = 1,
                   KernelKind kernel = KernelKind::kNone) {
    const auto scaled = [&](uint64_t seed) {
      Transform by;
      for (const size_t i : {0u, 5u, 10u}) by.m[i] = scale;
      return scenes::sampled(scene, seed, by);
    };
    problem = problem_between(scaled(1), scaled(2));
    Task task;
    IcpState state;
    state.T_reference_moving = problem.clouds.to_local({});
    state.last.kernel = {kernel, 1.1 * kNoise_m * scale};
    state.last.rule = {IcpMetric::kPointToPlane, 0.05 * scale, 0, 0.7, 16};
    const IcpLevel all;
    state.last.neighbours =
        IcpSearch(problem.clouds, all, 0.7, task).find(state.T_reference_moving, 0.5 * scale, task);
    found = icp_covariance(problem, state, task);
  }
};

}  // namespace

TEST_CASE("icp_covariance__holds_a_shift_about_as_well_as_the_points_of_both_clouds_can") {
  const Covered three(three_sheets());
  Cholesky<6> factor;
  REQUIRE(factor.factor(three.found.covariance));
  const Square<6> information = factor.inverse();
  // Of a sheet of n points in either cloud at best (s^2 / n + s^2 / n)^-1: pairs waste some of it, at the sheets'
  // borders and where points stand in more pairs than others. The scatter of 1800 points is good to a few per cent.
  const double best = 600 / (2 * kNoise_m * kNoise_m);
  for (const size_t shift : {3u, 4u, 5u}) {
    CHECK(information[7 * shift] < 1.1 * best);
    CHECK(information[7 * shift] > 0.75 * best);
  }
  CHECK(three.found.sigma0 == doctest::Approx(1).epsilon(0.1));
  CHECK(three.found.redundancy > 1800);
  for (size_t k = 1; k < 6; ++k) {
    CHECK(three.found.directions[k].observable);
    CHECK(three.found.directions[k].sigma_m <= three.found.directions[k - 1].sigma_m);
  }
}

TEST_CASE("icp_covariance__directions_make_it_up_again") {
  const Covered three(three_sheets());
  const double extent_m = three.problem.extent_m;
  const auto length = [&](size_t i) { return i < 3 ? extent_m : 1.0; };
  Square<6> sum{};
  for (const PoseDirection& d : three.found.directions)
    for (size_t i = 0; i < 6; ++i)
      for (size_t k = 0; k < 6; ++k)
        sum[6 * i + k] += d.sigma_m * d.sigma_m * d.unit[i] * d.unit[k] / (length(i) * length(k));
  for (size_t i = 0; i < 6; ++i)
    for (size_t k = 0; k < 6; ++k) {
      const double size = std::sqrt(sum[7 * i] * sum[7 * k]);
      CHECK(std::abs(sum[6 * i + k] - three.found.covariance[6 * i + k]) < 1e-9 * size);
    }
}

TEST_CASE("icp_covariance__grows_with_the_square_of_all_lengths") {
  const Square<6> once = Covered(three_sheets()).found.covariance,
                  twice = Covered(three_sheets(), 2).found.covariance;
  for (size_t i = 0; i < 6; ++i)
    for (size_t k = 0; k < 6; ++k) {
      const double factor = (i < 3 ? 1 : 2) * (k < 3 ? 1 : 2);
      const double size = std::sqrt(once[7 * i] * once[7 * k]);
      // Planes are kept as floats, and the trees' grids lie otherwise.
      CHECK(std::abs(twice[6 * i + k] / factor - once[6 * i + k]) < 1e-3 * size);
    }
}

TEST_CASE("icp_covariance__of_a_robust_kernel_is_larger_by_what_its_weights_cost") {
  const Square<6> all = Covered(three_sheets()).found.covariance,
                  robust = Covered(three_sheets(), 1, KernelKind::kTukey).found.covariance;
  // 5 % of the efficiency for noise of each pair alone, less where points stand in many pairs.
  for (size_t i = 0; i < 6; ++i) {
    CHECK(robust[7 * i] > 1.005 * all[7 * i]);
    CHECK(robust[7 * i] < all[7 * i] / 0.95);
  }
}

TEST_CASE("icp_covariance__of_one_plane_is_unknown_and_names_the_open_directions_first") {
  const Covered plane(scenes::one_plane());
  for (const double c : plane.found.covariance) CHECK(std::isnan(c));
  for (size_t k = 0; k < 6; ++k) {
    const PoseDirection& d = plane.found.directions[k];
    CHECK(d.observable == (k >= 3));
    CHECK(std::isnan(d.sigma_m) == (k < 3));
    // Of a wall across y: shifts along x and z and turns about y are open.
    const double open = d.unit[1] * d.unit[1] + d.unit[3] * d.unit[3] + d.unit[5] * d.unit[5];
    CHECK(std::fabs(open - (k < 3 ? 1 : 0)) < 0.01);
  }
}
