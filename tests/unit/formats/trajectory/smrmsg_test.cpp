// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/trajectory/smrmsg.h"

#include <doctest/doctest.h>

#include "unit/formats/trajectory/flights.h"

using namespace jalon;
using namespace jalon::test;

TEST_CASE("smrmsg__at_one_hertz__gives_every_epoch_its_sigmas_along_the_grid") {
  Folder folder;
  const std::string path = folder.file("sbet.out"), sigmas = folder.file("smrmsg.out");
  spill(path, bytes_of(northwards(300)));
  spill(sigmas, bytes_of(sigma_lines(345599.5, 4)));
  Task task;
  TrajectoryFileSettings settings;
  settings.projection = MapSystem::kLambert93;
  const Trajectory made = read_trajectory(path, sigmas, settings, task);
  REQUIRE(made.position_sigmas_m.size() == 300);
  // Half a second behind the first record: 0.025 m north, 0.03 m east, turned by 0.47 degrees.
  const double c = std::cos(0.4716450473 * kDegreeOf), s = std::sin(0.4716450473 * kDegreeOf);
  CHECK(made.position_sigmas_m[0].x == doctest::Approx(std::hypot(c * 0.03, s * 0.025)));
  CHECK(made.position_sigmas_m[0].y == doctest::Approx(std::hypot(s * 0.03, c * 0.025)));
  CHECK(made.position_sigmas_m[0].z == doctest::Approx(0.05));
  CHECK(made.position_sigmas_m[200].y == doctest::Approx(0.045).epsilon(1e-4).scale(0));
  CHECK(made.velocity_sigmas_m_s[0].z == 0.007);
  CHECK(made.attitude_sigmas_rad[0].x == doctest::Approx(0.3 / 60 * kDegreeOf));  // minutes of arc
  CHECK(made.attitude_sigmas_rad[0].z == doctest::Approx(1.2 / 60 * kDegreeOf));
  validate(made);
}

TEST_CASE("smrmsg__that_ends_early_or_is_wrong__is_refused_with_record_and_field") {
  Folder folder;
  const std::string path = folder.file("sbet.out"), sigmas = folder.file("smrmsg.out");
  spill(path, bytes_of(northwards(300)));
  spill(sigmas, bytes_of(sigma_lines(345600, 2)));  // held for one second, the drive lasts three
  CHECK(refusal_of_reading(path, sigmas) ==
        "the sigmas last from 345600 to 345601; the trajectory has time 345602.99");
  auto lines = sigma_lines(345599, 5);
  lines[2][kSmrmsgDown] = 0;
  spill(sigmas, bytes_of(lines));
  CHECK(refusal_of_reading(path, sigmas) ==
        "offset 184: record 2: down position sigma is 0; a standard deviation must be positive");
  lines = sigma_lines(345599, 5);
  lines[4][kSmrmsgHeading] = std::nan("");
  spill(sigmas, bytes_of(lines));
  CHECK(refusal_of_reading(path, sigmas) == "offset 392: record 4: heading sigma is nan");
  lines = sigma_lines(345599, 5);
  lines[1][kSmrmsgTime] = 345599;
  spill(sigmas, bytes_of(lines));
  CHECK(refusal_of_reading(path, sigmas) ==
        "offset 80: record 1: time is 345599, not after that of the record before, 345599");
}
