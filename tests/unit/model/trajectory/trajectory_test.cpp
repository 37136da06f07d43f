// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "model/trajectory/trajectory.h"

#include <doctest/doctest.h>

#include <numbers>
#include <string>

#include "base/error.h"
#include "base/numbers.h"
#include "unit/model/trajectory/drives.h"

using namespace jalon;

namespace {

std::string refusal_of_trajectory(const Trajectory& trajectory) {
  try {
    validate(trajectory);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("trajectory__that_is_whole__is_valid") {
  CHECK(refusal_of_trajectory(bent_drive(10)).empty());
}

TEST_CASE("trajectory__wrong_in_one_place__is_refused_with_epoch_and_field") {
  auto wrong = [](auto change) {
    Trajectory drive = bent_drive(10);
    change(drive);
    return refusal_of_trajectory(drive);
  };
  CHECK(wrong([](Trajectory& t) { t.times_s[4] = t.times_s[3]; }) ==
        "epoch 4 of the trajectory: time 1003 is not after time 1003 of the epoch before");
  CHECK(wrong([](Trajectory& t) { t.times_s[2] = kNaN; }) ==
        "epoch 2 of the trajectory: time is nan");
  CHECK(wrong([](Trajectory& t) { t.positions[7].y = kNaN; }) ==
        "epoch 7 of the trajectory: position y is nan");
  CHECK(wrong([](Trajectory& t) { t.attitudes_rad[1].z = kNaN; }) ==
        "epoch 1 of the trajectory: attitude yaw is nan");
  CHECK(wrong([](Trajectory& t) { t.position_sigmas_m[5].z = 0; }) ==
        "epoch 5 of the trajectory: position sigma z is 0; a standard deviation must be positive");
  CHECK(wrong([](Trajectory& t) {
          t.attitude_sigmas_rad[3].x = -1;
        }).find("epoch 3 of the trajectory: attitude sigma roll is -1") == 0);
  CHECK(wrong([](Trajectory& t) { t.velocity_sigmas_m_s.pop_back(); }) ==
        "there are 10 epochs and 9 of velocity sigma");
  CHECK(wrong([](Trajectory& t) { t.times_s.resize(1); }) ==
        "a trajectory of 1 epochs: two are needed");
}

TEST_CASE("attitude__of_both_conventions__turns_the_vehicle_as_its_name_says") {
  const double right = std::numbers::pi / 2;
  // East-north-up: no yaw looks east, the left is north.
  const Matrix3 enu = attitude_rotation(AxesConvention::kEnu, {});
  CHECK(norm(enu * Vec3{1, 0, 0} - Vec3{1, 0, 0}) < 1e-15);
  // North-east-down: no heading looks north, the right is east, the third axis points down.
  const Matrix3 ned = attitude_rotation(AxesConvention::kNed, {});
  CHECK(norm(ned * Vec3{1, 0, 0} - Vec3{0, 1, 0}) < 1e-15);
  CHECK(norm(ned * Vec3{0, 1, 0} - Vec3{1, 0, 0}) < 1e-15);
  CHECK(norm(ned * Vec3{0, 0, 1} - Vec3{0, 0, -1}) < 1e-15);
  // A heading of 90 degrees looks east; a positive pitch lifts the nose.
  CHECK(norm(attitude_rotation(AxesConvention::kNed, {0, 0, right}) * Vec3{1, 0, 0} -
             Vec3{1, 0, 0}) < 1e-15);
  CHECK((attitude_rotation(AxesConvention::kNed, {0, 0.1, 0}) * Vec3{1, 0, 0}).z > 0);
  // The same stand in both: x forward, y left, z up is x forward, y right, z down half a turn about x.
  const Matrix3 same = attitude_rotation(AxesConvention::kEnu, {0.03, -0.02, right - 0.7});
  const Matrix3 other = attitude_rotation(AxesConvention::kNed, {0.03, 0.02, 0.7});
  CHECK(norm(same * Vec3{1, 2, 3} - other * Vec3{1, -2, -3}) < 1e-14);
  for (AxesConvention axes : {AxesConvention::kEnu, AxesConvention::kNed}) {
    const Vec3 angles{0.1, -0.2, 2.5};
    CHECK(norm(attitude_angles(axes, attitude_rotation(axes, angles)) - angles) < 1e-14);
  }
}
