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
