// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <numbers>

#include "base/random.h"
#include "geometry/rotation.h"

using namespace jalon;

namespace {

double largest_difference(const Matrix3& a, const Matrix3& b) {
  double most = 0;
  for (size_t i = 0; i < 9; ++i) most = std::max(most, std::fabs(a.m[i] - b.m[i]));
  return most;
}

Vec3 some_angles(RandomStream& random) {
  const auto any = [&] { return (random.uniform() - 0.5) * 2 * std::numbers::pi; };
  return {any(), any() / 2, any()};
}

}  // namespace

TEST_CASE("rotation__quarter_turns__follow_the_right_hand") {
  const double quarter = std::numbers::pi / 2;
  CHECK(norm(rotation_x(quarter) * Vec3{0, 1, 0} - Vec3{0, 0, 1}) < 1e-15);
  CHECK(norm(rotation_y(quarter) * Vec3{0, 0, 1} - Vec3{1, 0, 0}) < 1e-15);
  CHECK(norm(rotation_z(quarter) * Vec3{1, 0, 0} - Vec3{0, 1, 0}) < 1e-15);
  // Roll first, yaw last.
  CHECK(norm(rotation_zyx({quarter, 0, quarter}) * Vec3{0, 1, 0} - Vec3{0, 0, 1}) < 1e-15);
}

TEST_CASE("rotation__angles_and_quaternions__give_the_same_matrix_back") {
  RandomStream random(1, 0);
  for (int i = 0; i < 1000; ++i) {
    const Matrix3 turned = rotation_zyx(some_angles(random));
    CHECK(largest_difference(rotation_zyx(angles_zyx(turned)), turned) < 1e-14);
    CHECK(largest_difference(matrix_of(quaternion_of(turned)), turned) < 1e-14);
    CHECK(largest_difference(turned * transposed(turned), Matrix3{}) < 1e-15);
  }
  const Matrix3 upright =
      rotation_zyx({0.3, std::numbers::pi / 2, 1.1});  // only their difference counts
  CHECK(largest_difference(rotation_zyx(angles_zyx(upright)), upright) < 1e-12);
}

TEST_CASE("rotation__half_turns__have_a_quaternion") {
  for (const Matrix3& half :
       {rotation_x(std::numbers::pi), rotation_y(std::numbers::pi), rotation_z(std::numbers::pi)})
    CHECK(largest_difference(matrix_of(quaternion_of(half)), half) < 1e-15);
}
