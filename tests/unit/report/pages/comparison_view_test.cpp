// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "report/pages/comparison_view.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "unit/report/pages/page_scenes.h"

using namespace jalon;
using page_scenes::comparison_of;

TEST_CASE("comparison_view__both_ways_on_the_reports_scale_hidden_points_apart") {
  const Comparison forward = comparison_of({0.01, -0.02, NAN, 0.005}),
                   reverse = comparison_of({0.03});
  FieldTable changes;
  const std::vector<double> rows = {1, 2};
  add_columns<double, 3>(changes, rows, "centroid", "m", "", [](double v, double* o) {
    o[0] = v;
    o[1] = 2 * v;
    o[2] = 0;
  });
  add_column<double>(changes, rows, "volume", "m3", "", [](double v) { return v / 8; });
  const DeviationScale scale{0.02, true};
  const ViewScene scene = comparison_scene(forward, &reverse, changes, scale);
  REQUIRE(scene.clouds.size() == 2);
  CHECK_FALSE(scene.clouds[0].is_hidden);
  CHECK(scene.clouds[1].is_hidden);
  const ViewChannel& distance = scene.clouds[0].channels.at(0);
  CHECK(distance.low == -0.02);
  CHECK(distance.high == 0.02);
  CHECK(distance.colours.size() == DeviationScale::kSteps);
  CHECK(distance.value(1) == -0.02);
  CHECK(distance.value(2) == -std::numeric_limits<double>::infinity());  // comparison_of: hidden
  REQUIRE(scene.parts.size() == 2);
  CHECK(scene.parts[1].tag == "2");
  CHECK(scene.parts[1].text.starts_with("region 2, volume 0.250"));
  CHECK(comparison_scene(forward, nullptr, {}, scale).clouds.size() == 1);
}
