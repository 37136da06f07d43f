// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Where a whole cloud may show a pattern: near each that is there, the most alike first.

#include "registration/targets/pattern_places.h"

#include <doctest/doctest.h>

#include "unit/registration/target_walls.h"

using namespace jalon;
using namespace jalon::test;

TEST_CASE("pattern_places__lie_near_the_patterns_and_rank_them_first") {
  TargetWall wall;
  wall.width_m = 2, wall.height_m = 1.5;
  wall.sheets = {checker_sheet(0.5, 0.7, 0.4, 0.1), disc_sheet(1.5, 0.8, 0.1)};
  const Cloud cloud = scan_of(wall, 1);
  Task task;
  const auto tree = cloud.octree(task);
  for (const Sheet& sheet : wall.sheets) {
    const auto places = pattern_places(cloud, *tree, *cloud.fields.find("intensity"), sheet.kind,
                                       0.1, 0.01, 30, task);
    REQUIRE(!places.empty());
    CHECK(norm(places[0].place - place_of(wall, sheet)) < 0.025);  // a quarter of its size
    CHECK(places[0].kind == sheet.kind);
    CHECK(places[0].likeness > 0.5);
    for (size_t i = 1; i < places.size(); ++i) {
      CHECK(places[i].likeness <= places[i - 1].likeness);
      for (size_t k = 0; k < i; ++k) CHECK(norm(places[i].place - places[k].place) >= 0.03);
    }
  }
}

TEST_CASE("pattern_places__lie_about_a_pattern_of_dense_points_and_of_sparse_ones") {
  // Dense: cells have several points and their means are looked at first; sparse: one.
  for (const double spacing_m : {0.0025, 0.008})
    for (const Sheet& sheet : {checker_sheet(0.4, 0.3, 0.4, 0.1), disc_sheet(0.4, 0.3, 0.1)}) {
      TargetWall wall;
      wall.width_m = 0.8, wall.height_m = 0.6;
      wall.spacing_m = spacing_m;
      wall.sheets = {sheet};
      const Cloud cloud = scan_of(wall, 3);
      Task task;
      const auto places =
          pattern_places(cloud, *cloud.octree(task), *cloud.fields.find("intensity"), sheet.kind,
                         0.1, 0.01, 30, task);
      REQUIRE(!places.empty());
      CHECK(norm(places[0].place - place_of(wall, sheet)) < 0.025);
      CHECK(places[0].likeness > 0.5);
      for (const PatternPlace& p : places) CHECK(norm(p.place - place_of(wall, sheet)) < 0.15);
    }
}

TEST_CASE("pattern_places__are_none_on_a_plain_wall") {
  TargetWall wall;
  wall.width_m = 2, wall.height_m = 1.5;
  const Cloud cloud = scan_of(wall, 2);
  Task task;
  CHECK(pattern_places(cloud, *cloud.octree(task), *cloud.fields.find("intensity"),
                       TargetKind::kChecker, 0.1, 0.01, 30, task)
            .empty());
}
