// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "report/pages/clearance_view.h"

#include <doctest/doctest.h>

#include <cmath>

#include "unit/report/charts/swept_gauge.h"

using namespace jalon;

TEST_CASE("clearance_view__points_in_the_colours_of_their_clearance_and_numbered_places") {
  const SweepTables tables = swept::tables();
  const GaugePath path(swept::way());
  const ViewScene scene = clearance_scene(swept::obstacles(), tables.places, path,
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
