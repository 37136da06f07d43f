// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "report/pages/clearance_view.h"

#include <doctest/doctest.h>

#include <cmath>

#include "compare/distance/model_sample.h"
#include "unit/report/charts/swept_gauge.h"

using namespace jalon;

TEST_CASE("clearance_view__points_in_the_colours_of_their_clearance_and_numbered_places") {
  const SweepTables tables = swept::tables();
  const GaugePath path(swept::way());
  const ViewScene scene = clearance_scene(swept::obstacles(), nullptr, tables.places, path,
                                          tight_places(tables.places, path, 1, 40), 0.1);
  REQUIRE(scene.clouds.size() == 1);
  const ViewChannel& channel = scene.clouds[0].channels[0];
  CHECK(channel.name == "clearance");
  CHECK(channel.low == doctest::Approx(-0.1));
  CHECK(channel.high == 0.1);
  CHECK(channel.value(0) == doctest::Approx(0.05));
  CHECK(channel.value(2) == doctest::Approx(-0.1));
  REQUIRE(scene.parts.size() == 3);  // the way and two places
  CHECK(scene.parts[0].rings[0].front().x == 0);
  CHECK(scene.parts[1].tag == "1");
  CHECK(scene.parts[2].text.find("0.050 m") != std::string::npos);
}

TEST_CASE("clearance_view__points_on_a_model_in_the_colours_of_their_triangles") {
  // A wall beside the way, 5 cm free, and one far away.
  Model wall;
  wall.vertices = {{4, 1.05, -1}, {6, 1.05, -1}, {5, 1.05, 1}, {4, 9, -1}, {6, 9, -1}, {5, 9, 1}};
  wall.triangles = {{0, 1, 2}, {3, 4, 5}};
  Task task;
  const std::vector<ConvexPiece> gauge{ConvexPiece::box({}, {2, 2, 3})};
  const SweepTables tables = sweep_tables(gauge, swept::way(), nullptr, &wall, {}, task);
  ModelSampleSettings sample;
  sample.points = 100;
  const auto points = std::make_shared<const Cloud>(sample_model(wall, sample, task));
  const GaugePath path(swept::way());
  const ViewScene scene = clearance_scene(nullptr, points, tables.places, path,
                                          tight_places(tables.places, path, 1, 40), 0.1);
  REQUIRE(scene.clouds.size() == 1);
  const ViewChannel& channel = scene.clouds[0].channels[0];
  size_t near = 0;
  for (size_t i = 0; i < points->size(); ++i) {
    const bool is_near = points->point(i).y < 2;
    near += is_near;
    if (is_near) CHECK(channel.value(i) == doctest::Approx(0.05));
    else CHECK(std::isnan(channel.value(i)));
  }
  CHECK(near > 0);
  CHECK(near < points->size());
}
