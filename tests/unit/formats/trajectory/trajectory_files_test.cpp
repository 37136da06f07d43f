// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/trajectory/trajectory_files.h"

#include <doctest/doctest.h>

#include "unit/formats/trajectory/flights.h"

using namespace jalon;
using namespace jalon::test;

TEST_CASE("projection_of__without_a_zone__takes_that_of_the_first_record") {
  TrajectoryFileSettings settings;
  CHECK(projection_of(settings, {0.8, 2.35 * kDegreeOf, 0}).crs() == "EPSG:32631");
  CHECK(projection_of(settings, {-0.8, 151 * kDegreeOf, 0}).crs() == "EPSG:32756");
  settings.utm_zone = 32;
  CHECK(projection_of(settings, {0.8, 2.35 * kDegreeOf, 0}).crs() == "EPSG:32632");
  settings.projection = MapSystem::kEnu;
  CHECK(projection_of(settings, {0.8, 0.1, 5}).origin.height_m == 5);
}

TEST_CASE("trajectory_files__sigmas_beside_a_text__are_refused") {
  Folder folder;
  const std::string path = folder.file("log.txt");
  spill(path, "time x y z roll pitch yaw\n1 0 0 0 0 0 0\n2 0 0 0 0 0 0\n");
  Task task;
  CHECK_THROWS_AS(read_trajectory(path, "smrmsg.out", {}, task), Error);
  TrajectoryFileSettings settings;
  settings.format = TrajectoryFormat::kSbet;  // whatever it is called
  CHECK_THROWS_AS(read_trajectory(path, "", settings, task), Error);
}

TEST_CASE("trajectory_files__with_a_shift_of_time__are_read_later_and_written_back_as_they_were") {
  Folder folder;
  Task task;
  Trajectory drive;
  for (int i = 0; i < 3; ++i) {
    drive.times_s.push_back(345600 + 0.25 * i);
    drive.positions.push_back({652301.0 + i, 6861302, 80});
    drive.attitudes_rad.push_back({0, 0, 0.1});
    drive.position_sigmas_m.push_back({0.02, 0.02, 0.05 + 0.01 * i});
  }
  TrajectoryFileSettings plain, later;
  plain.projection = later.projection = MapSystem::kLambert93;
  later.time_shift_s = 2391 * 604800.0 - 1e9;  // from seconds of GPS week 2391 to those of LAS
  for (const char* name : {"drive.txt", "drive.out"}) {
    const std::string path = folder.file(name);
    write_trajectory(drive, path, "", plain, task);
    const Trajectory read = read_trajectory(path, "", later, task);
    for (size_t i = 0; i < 3; ++i) CHECK(read.times_s[i] == drive.times_s[i] + later.time_shift_s);
    write_trajectory(read, path, "", later, task);
    CHECK(read_trajectory(path, "", plain, task).times_s == drive.times_s);
  }
}
