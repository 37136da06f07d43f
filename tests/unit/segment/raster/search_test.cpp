// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/raster/search.h"

#include <doctest/doctest.h>

#include <map>

#include "unit/segment/made_scene.h"

using namespace jalon;
using namespace jalon::test;

namespace {

const ImageAxes kFromAbove{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

// A floor of 4 x 4 m with 2 mm of noise, and a table of 0.5 x 0.5 m above it.
Scene floor_with_table() {
  Scene scene;
  RandomStream random(8, 2);
  scene.rectangle(1, {0, 0, 0}, {4, 0, 0}, {0, 4, 0}, 16000, 0.002, random);
  scene.rectangle(2, {1, 1, 0.7}, {0.5, 0, 0}, {0, 0.5, 0}, 250, 0.002, random);
  return scene;
}

// How many points each owner has of each face.
std::map<std::pair<uint32_t, int>, size_t> shares(MadeScene& made, const Scene& scene) {
  std::map<std::pair<uint32_t, int>, size_t> out;
  for (uint32_t p = 0; p < made.scene.size(); ++p)
    ++out[{made.scene.owner[p], scene.faces[made.point(p)]}];
  return out;
}

}  // namespace

TEST_CASE("search_rasters__numbers_what_it_finds_from_the_first_id_on") {
  const Scene scene = floor_with_table();
  MadeScene made(scene.points);
  const ImageAxes axes[] = {kFromAbove};
  // The floor, the table, and the floor below it, which the first raster does not show.
  CHECK(search_rasters(made.scene, {}, axes, {}, 5, made.task) == 3);
  auto found = shares(made, scene);
  uint32_t floor = 0, table = 0;
  for (uint32_t id = 5; id <= 7; ++id) {
    if (found[{id, 1}] > 15000) floor = id;
    if (found[{id, 2}] > 220) table = id;
  }
  REQUIRE(floor != 0);
  REQUIRE(table != 0);
  CHECK(found[{floor, 2}] == 0);
  CHECK(found[{table, 1}] == 0);
  CHECK(found[{0, 1}] < 200);
}

TEST_CASE("search_rasters__on_wide_pixels__finds_large_planes_among_every_so_many_th_point") {
  const Scene scene = floor_with_table();
  MadeScene made(scene.points);
  const ImageAxes axes[] = {kFromAbove};
  const RasterScale scale{16, 4, 100, false};
  CHECK(search_rasters(made.scene, {}, axes, scale, 1, made.task) == 1);
  size_t floor = 0;
  for (uint32_t p = 0; p < made.scene.size(); ++p) {
    if (made.scene.owner[p] == 0) continue;
    CHECK(p % 16 == 0);
    floor += scene.faces[made.point(p)] == 1;
  }
  CHECK(floor > 900);  // of 1000
}
