// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/settle/merging.h"

#include <doctest/doctest.h>

#include "unit/segment/made_scene.h"

using namespace jalon;
using namespace jalon::test;

namespace {

// Two upright rectangles of 2 x 2 m, the second a gap further on and an offset behind.
Scene two_walls(double gap_m, double offset_m) {
  Scene out;
  RandomStream random(1, 7);
  out.rectangle(1, {0, 0, 0}, {2, 0, 0}, {0, 0, 2}, 2000, 0.004, random);
  out.rectangle(2, {2 + gap_m, offset_m, 0}, {2, 0, 0}, {0, 0, 2}, 2000, 0.004, random);
  return out;
}

size_t left_after_merging(double gap_m, double offset_m, double merge_gap_m) {
  const Scene walls = two_walls(gap_m, offset_m);
  SurfaceSettings settings;
  settings.merge_gap_m = merge_gap_m;
  MadeScene made(walls.points, settings);
  auto surfaces = made.surfaces(walls.faces, 2);
  merge_coplanar(made.scene, surfaces, made.task);
  return surfaces.size();
}

}  // namespace

TEST_CASE("merging__coplanar_neighbours_become_one_with_the_points_of_both") {
  const Scene walls = two_walls(0.3, 0);
  MadeScene made(walls.points);
  auto surfaces = made.surfaces(walls.faces, 2);
  const double area_m2 = surfaces[0].area_m2 + surfaces[1].area_m2;
  merge_coplanar(made.scene, surfaces, made.task);
  REQUIRE(surfaces.size() == 1);
  CHECK(surfaces[0].positions.size() == 4000);
  CHECK(std::is_sorted(surfaces[0].positions.begin(), surfaces[0].positions.end()));
  CHECK(surfaces[0].area_m2 == doctest::Approx(area_m2));
  CHECK(std::fabs(surfaces[0].plane.normal.y) > 0.99999);
}

TEST_CASE("merging__gap_and_offset_keep_surfaces_apart") {
  CHECK(left_after_merging(0.3, 0, 0.5) == 1);
  CHECK(left_after_merging(1.0, 0, 0.5) == 2);
  CHECK(left_after_merging(1.0, 0, 1.5) == 1);
  CHECK(left_after_merging(0.3, 0.1, 0.5) == 2);  // a step of four tolerances
}

TEST_CASE("merging__layers_over_one_another_within_the_noise_become_one") {
  Scene layers;
  RandomStream random(2, 7);
  layers.rectangle(1, {0, 0, 0}, {2, 0, 0}, {0, 0, 2}, 3000, 0.004, random);
  layers.rectangle(2, {0.5, 0.008, 0.5}, {1, 0, 0}, {0, 0, 1}, 300, 0.002, random);
  layers.rectangle(3, {0.5, 0.2, 0.5}, {1, 0, 0}, {0, 0, 1}, 300, 0.002, random);  // a pane behind
  layers.rectangle(4, {2.2, 0, 0}, {1, 0, 0}, {0, 0, 2}, 1000, 0.004, random);     // beside it
  MadeScene made(layers.points);
  auto surfaces = made.surfaces(layers.faces, 4);
  CHECK(merge_layers(made.scene, surfaces, made.task));
  REQUIRE(surfaces.size() == 3);
  CHECK(surfaces[0].positions.size() == 3300);
  CHECK_FALSE(merge_layers(made.scene, surfaces, made.task));
  CHECK(surfaces.size() == 3);
}
