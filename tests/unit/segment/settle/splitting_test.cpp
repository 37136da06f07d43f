// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/settle/splitting.h"

#include <doctest/doctest.h>

#include "unit/segment/made_scene.h"

using namespace jalon;
using namespace jalon::test;

namespace {

// One face in two pieces: 2 x 2 m and 1 x 2 m, a gap between.
Scene pieces(double gap_m, size_t second) {
  Scene out;
  RandomStream random(1, 7);
  out.rectangle(1, {0, 0, 0}, {2, 0, 0}, {0, 0, 2}, 2000, 0.004, random);
  out.rectangle(1, {2 + gap_m, 0, 0}, {1, 0, 0}, {0, 0, 2}, second, 0.004, random);
  return out;
}

}  // namespace

TEST_CASE("splitting__parts_far_apart_become_surfaces_and_keep_all_points") {
  const Scene face = pieces(1.5, 1000);
  MadeScene made(face.points);
  auto surfaces = made.surfaces(face.faces, 1);
  REQUIRE(split_surfaces(made.scene, surfaces, made.task));
  REQUIRE(surfaces.size() == 2);
  CHECK(surfaces[0].positions.size() == 2000);  // the larger part keeps its place
  CHECK(surfaces[1].positions.size() == 1000);
  CHECK(surfaces[1].area_m2 == doctest::Approx(2).epsilon(0.15));
  for (const uint32_t p : surfaces[1].positions) CHECK(made.scene.exact(p).x > 3);
}

TEST_CASE("splitting__what_connectivity_and_merging_bridge_stays_one") {
  const Scene face = pieces(0.3, 1000);
  MadeScene made(face.points);
  auto surfaces = made.surfaces(face.faces, 1);
  CHECK_FALSE(split_surfaces(made.scene, surfaces, made.task));
  CHECK(surfaces.size() == 1);
  std::vector<Surface> none;
  CHECK_FALSE(split_surfaces(made.scene, none, made.task));
}

TEST_CASE("splitting__parts_too_small_for_a_segment_are_set_free") {
  const Scene face = pieces(1.5, 40);  // below min_points
  MadeScene made(face.points);
  auto surfaces = made.surfaces(face.faces, 1);
  REQUIRE(split_surfaces(made.scene, surfaces, made.task));
  REQUIRE(surfaces.size() == 1);
  CHECK(surfaces[0].positions.size() == 2000);
  for (size_t p = 0; p < made.scene.size(); ++p)
    CHECK(made.scene.owner[p] == (made.scene.exact(p).x < 3 ? 1u : 0u));
}
