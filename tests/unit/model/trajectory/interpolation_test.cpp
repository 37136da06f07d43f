// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "model/trajectory/interpolation.h"

#include <doctest/doctest.h>

#include <numbers>

#include "base/error.h"
#include "base/random.h"
#include "unit/model/trajectory/drives.h"

using namespace jalon;

TEST_CASE("time_place__with_any_hint__is_the_interval_that_holds_the_time") {
  const Trajectory drive = bent_drive(50, 0.3);
  RandomStream random(3, 0);
  for (int i = 0; i < 2000; ++i) {
    const double time = 1000 + random.uniform() * 0.3 * 49;
    const TimePlace at = time_place(drive.times_s, time, 0, random.below(60));
    REQUIRE(at.epoch < 49);
    CHECK(at.share >= 0);
    CHECK(at.share <= 1);
    CHECK(drive.times_s[at.epoch] +
              at.share * (drive.times_s[at.epoch + 1] - drive.times_s[at.epoch]) ==
          doctest::Approx(time).epsilon(1e-15));
  }
  CHECK(time_place(drive.times_s, drive.times_s.back(), 0).epoch == 48);
  CHECK(time_place(drive.times_s, drive.times_s.back(), 0).share == 1);
  CHECK(time_place(drive.times_s, drive.times_s.front(), 0).share == 0);
}

TEST_CASE("time_place__outside_of_the_trajectory__names_item_and_time") {
  const Trajectory drive = bent_drive(3);
  try {
    time_place(drive.times_s, 1002.5, 17);
    FAIL("no refusal");
  } catch (const Error& error) {
    CHECK(std::string(error.what()) ==
          "time 1002.5 of item 17 is outside of the trajectory, which lasts from 1000 to 1002");
  }
}

TEST_CASE("interpolation__between_epochs__is_straight_and_turns_on_the_shortest_arc") {
  Trajectory drive = bent_drive(3);
  drive.attitudes_rad = {{0, 0, 3.1}, {0, 0, -3.1}, {0, 0, -3}};
  const double times[] = {1000.5, 1001, 1001.75};
  const Trajectory made = interpolated(drive, times);
  CHECK(norm(made.positions[0] - (drive.positions[0] + drive.positions[1]) * 0.5) < 1e-9);
  CHECK(std::fabs(made.attitudes_rad[0].z) == doctest::Approx(std::numbers::pi));
  CHECK(norm(made.positions[1] - drive.positions[1]) == 0);
  CHECK(made.attitudes_rad[2].z == doctest::Approx(-3.025));
  CHECK(made.position_sigmas_m[2].x ==
        doctest::Approx(0.25 * drive.position_sigmas_m[1].x + 0.75 * drive.position_sigmas_m[2].x));
  CHECK(made.crs == drive.crs);
  CHECK(made.velocities_m_s.empty());
}

TEST_CASE("control_times__of_any_length__begin_and_end_with_the_trajectory") {
  const Trajectory drive = bent_drive(5341, 0.01);  // 53.4 s of 100 Hz
  const std::vector<double> times = control_times(drive, 1);
  CHECK(times.size() == 54);
  CHECK(times.front() == 1000);
  CHECK(times[1] == 1001);
  CHECK(times.back() == drive.times_s.back());
  CHECK(times.back() - times[52] == doctest::Approx(1.4));
  CHECK(control_times(drive, 1e6).size() == 2);
  CHECK_THROWS_AS(control_times(drive, 0), Error);
  CHECK_THROWS_AS(control_times(drive, 1e-12), Error);
  CHECK(interpolated(drive, times).size() == 54);
}

TEST_CASE("interpolation__of_attitudes__turns_evenly_about_one_axis_by_less_than_half_a_turn") {
  RandomStream random(7, 0);
  const auto any = [&] { return (random.uniform() - 0.5) * 6; };
  for (int draw = 0; draw < 200; ++draw) {
    const Matrix3 start = rotation_zyx({any(), any() / 2.1, any()});
    const double turn = any() / 2.0;
    Trajectory drive = bent_drive(2);
    drive.attitudes_rad = {angles_zyx(start), angles_zyx(start * rotation_x(turn))};
    const PoseInterpolator poses(drive);
    for (const double share : {0.0, 0.1, 0.5, 0.9, 1.0}) {
      const Matrix3 made = poses.rotation({0, share}), wanted = start * rotation_x(share * turn);
      for (size_t k = 0; k < 9; ++k) CHECK(std::fabs(made.m[k] - wanted.m[k]) < 1e-13);
    }
  }
}
