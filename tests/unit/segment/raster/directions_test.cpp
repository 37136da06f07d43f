// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/raster/directions.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "unit/segment/made_scene.h"

using namespace jalon;
using namespace jalon::test;

TEST_CASE("directions__of_a_box_are_its_three_most_points_first") {
  Scene scene;
  RandomStream random(3, 0);
  scene.rectangle(1, {0, 0, 0}, {6, 0, 0}, {0, 0, 4}, 20000, 0.002, random);
  scene.rectangle(2, {0, 0, 0}, {0, 4, 0}, {0, 0, 4}, 12000, 0.002, random);
  scene.rectangle(3, {0, 0, 0}, {6, 0, 0}, {0, 4, 0}, 8000, 0.002, random);
  MadeScene made(scene.points);
  const auto directions = dominant_directions(made.scene, 12, made.task);
  REQUIRE(directions.size() == 3);
  const Vec3 axes[] = {{0, 1, 0}, {1, 0, 0}, {0, 0, 1}};
  for (size_t k = 0; k < 3; ++k) CHECK(dot(directions[k], axes[k]) > std::cos(0.01));
  CHECK(dominant_directions(made.scene, 2, made.task).size() == 2);
}

TEST_CASE("directions__without_normals_are_that_of_all_points") {
  std::vector<Vec3> few;
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k) few.push_back({10.0 * i, 10.0 * k, 0});
  MadeScene made(few);
  const auto directions = dominant_directions(made.scene, 12, made.task);
  REQUIRE(directions.size() == 1);
  CHECK(directions[0].z == doctest::Approx(1));
}

TEST_CASE("directions__turn_toward_the_stations") {
  Cloud cloud = *cloud_of({{0, 0, 0}, {1, 0, 0}, {0, 0, 1}});
  CHECK(toward_viewers(cloud, {}, {0, 1, 0}, {}) == Vec3{0, 1, 0});
  Station station;
  station.has_pose = true;
  station.pose.m[7] = -5;
  station.count = 3;
  cloud.stations.push_back(station);
  CHECK(toward_viewers(cloud, {}, {0, 1, 0}, {}).y == -1);
}
