// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "model/trajectory/laser_beam.h"

#include <doctest/doctest.h>

#include <Eigen/Dense>

#include "base/distributions.h"
#include "unit/model/trajectory/laser_inputs.h"

using namespace jalon;

TEST_CASE("laser_beam__worked_example__has_the_point_and_the_covariance_of_the_hand_calculation") {
  const double d = kDegrees_rad;
  const LaserInputs l = {12,  30 * d, 75 * d, 0.01,    -0.02,    0.03,   1 * d, -2 * d, 45 * d,
                         0.5, 0.2,    1.8,    0.8 * d, -1.2 * d, 37 * d, 100,   200,    50};
  const BeamGeometry geometry(mount_of(l, BoresightOrder::kZyx));
  const VehiclePose pose = pose_of(l, AxesConvention::kEnu);
  const Vec3 p = geometry.beam(return_of(l), pose).point;
  CHECK(std::fabs(p.x - 95.949155) < 5e-7);
  CHECK(std::fabs(p.y - 210.957978) < 5e-7);
  CHECK(std::fabs(p.z - 55.613209) < 5e-7);
  const Symmetric3 c = geometry.covariance(return_of(l), pose, usual_sigmas());
  const double printed[6] = {7.950407e-04, 1.353306e-04,  4.065763e-05,
                             5.248749e-04, -1.181963e-04, 1.300320e-03};
  for (size_t i = 0; i < 6; ++i)
    CHECK(std::fabs(c[i] - printed[i]) <= 5.1e-7 * std::fabs(printed[i]));
  const Eigen3 axes = symmetric_eigen(c);
  CHECK(axes.values[2] == doctest::Approx(1.318758e-03).epsilon(1e-6).scale(0));
  CHECK(axes.values[1] == doctest::Approx(8.510473e-04).epsilon(1e-6).scale(0));
  CHECK(axes.values[0] == doctest::Approx(4.504307e-04).epsilon(1e-6).scale(0));
}

TEST_CASE("laser_beam__by_groups_of_inputs__has_the_shares_of_the_hand_calculation") {
  const double d = kDegrees_rad;
  const LaserInputs l = {12,  30 * d, 75 * d, 0.01,    -0.02,    0.03,   1 * d, -2 * d, 45 * d,
                         0.5, 0.2,    1.8,    0.8 * d, -1.2 * d, 37 * d, 100,   200,    50};
  const BeamGeometry geometry(mount_of(l, BoresightOrder::kZyx));
  const auto share = [&](size_t first, size_t last) {
    LaserSigmas some{};
    for (size_t k = first; k < last; ++k) some[k] = usual_sigmas()[k];
    const Symmetric3 c = geometry.covariance(return_of(l), pose_of(l, AxesConvention::kEnu), some);
    return std::sqrt(c[0] + c[3] + c[5]);
  };
  CHECK(std::fabs(share(0, 3) - 0.0050) < 5e-5);    // scanner
  CHECK(std::fabs(share(3, 6) - 0.0017) < 5e-5);    // mirror
  CHECK(std::fabs(share(6, 9) - 0.0295) < 5e-5);    // boresight
  CHECK(std::fabs(share(9, 12) - 0.0017) < 5e-5);   // lever arm
  CHECK(std::fabs(share(12, 15) - 0.0043) < 5e-5);  // attitude
  CHECK(std::fabs(share(15, 18) - 0.0412) < 5e-5);  // position
}

TEST_CASE("laser_beam__all_18_derivatives__agree_with_finite_differences_in_every_convention") {
  RandomStream random(4, 0);
  double worst = 0;
  for (int draw = 0; draw < 200; ++draw) {
    const LaserInputs l = any_inputs(random);
    for (BoresightOrder order : {BoresightOrder::kZyx, BoresightOrder::kXyz})
      for (AxesConvention axes : {AxesConvention::kEnu, AxesConvention::kNed}) {
        const auto J = BeamGeometry(mount_of(l, order)).jacobian(return_of(l), pose_of(l, axes));
        for (size_t k = 0; k < kLaserInputs; ++k) {
          // Four values: the error of the differences is of the fourth order in the step.
          constexpr double kStep = 1e-3;
          const auto at = [&](double steps) {
            LaserInputs moved = l;
            moved[k] += steps * kStep;
            return point_of(moved, order, axes);
          };
          const Vec3 slope = (8.0 * (at(1) - at(-1)) - (at(2) - at(-2))) / (12 * kStep);
          worst = std::max(worst, norm(slope - J[k]) / std::max(1.0, l[0]));
        }
      }
  }
  MESSAGE("FIGURE derivatives against finite differences: at most ", worst, " (of the range)");
  CHECK(worst < 1e-9);  // 1e-7 at the longest range, 100 m
}

TEST_CASE("laser_beam__of_10000_simulated_returns__has_95_percent_within_its_ellipsoids") {
  const double bound = chi_square_quantile(3, 0.95);
  for (uint64_t seed : {101u, 102u, 103u}) {
    RandomStream random(seed, 0);
    int within = 0;
    for (int draw = 0; draw < 10000; ++draw) {
      const LaserInputs truth = any_inputs(random);
      LaserInputs measured = truth;
      for (size_t k = 0; k < kLaserInputs; ++k) measured[k] += usual_sigmas()[k] * random.normal();
      // As a user has it: point and covariance from what was measured.
      const Symmetric3 c = BeamGeometry(mount_of(measured, BoresightOrder::kZyx))
                               .covariance(return_of(measured),
                                           pose_of(measured, AxesConvention::kEnu), usual_sigmas());
      Eigen::Matrix3d C;
      C << c[0], c[1], c[2], c[1], c[3], c[4], c[2], c[4], c[5];
      const Vec3 e = point_of(measured) - point_of(truth);
      const Eigen::Vector3d v(e.x, e.y, e.z);
      within += v.dot(C.ldlt().solve(v)) <= bound;
    }
    MESSAGE("FIGURE truth within 95 % ellipsoids: ", within / 100.0, " %");
    CHECK(within >= 9400);
    CHECK(within <= 9600);
  }
}

TEST_CASE("laser_beam__origin_and_direction__lead_to_the_point") {
  RandomStream random(5, 0);
  for (int draw = 0; draw < 100; ++draw) {
    const LaserInputs l = any_inputs(random);
    const WorldBeam beam = BeamGeometry(mount_of(l, BoresightOrder::kZyx))
                               .beam(return_of(l), pose_of(l, AxesConvention::kEnu));
    CHECK(norm(beam.direction) == doctest::Approx(1));
    CHECK(norm(beam.origin + beam.direction * l[0] - beam.point) < 1e-12);
    LaserInputs none = l;  // of no range: the laser's centre
    none[0] = 0;
    CHECK(norm(beam.origin - point_of(none)) < 1e-11);
  }
}

TEST_CASE("vehicle_pose__standing_on_its_tail__still_has_axes") {
  const VehiclePose pose = vehicle_pose(rotation_y(-std::numbers::pi / 2), {}, false);
  for (const Vec3& axis : pose.attitude_axes) CHECK(norm(axis) == doctest::Approx(1));
}
