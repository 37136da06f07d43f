// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "model/trajectory/corrections.h"

#include <doctest/doctest.h>

#include "base/error.h"
#include "unit/model/trajectory/drives.h"

using namespace jalon;

TEST_CASE("corrected__between_control_times__moves_in_plan_along_a_line") {
  const Trajectory drive = bent_drive(11);
  const Corrections by{{1000, 1010}, {{0, 1}, {2, 1}}};
  const Trajectory made = corrected(drive, by);
  for (size_t i = 0; i < drive.size(); ++i) {
    const Vec3 moved = made.positions[i] - drive.positions[i];
    CHECK(moved.x == doctest::Approx(0.2 * static_cast<double>(i)));
    CHECK(moved.y == doctest::Approx(1));
    CHECK(moved.z == 0);
    CHECK(made.attitudes_rad[i] == drive.attitudes_rad[i]);
  }
  CHECK_THROWS_AS(corrected(drive, {{1001, 1010}, {{0, 0}, {0, 0}}}), Error);
}
