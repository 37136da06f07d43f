// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/settle/assignment.h"

#include <doctest/doctest.h>

#include "unit/segment/made_scene.h"

using namespace jalon;
using namespace jalon::test;

namespace {

// A floor and a wall that meet along X, and a loose point far above both.
Scene corner() {
  Scene out;
  RandomStream random(1, 7);
  out.rectangle(1, {0, 0, 0}, {3, 0, 0}, {0, 3, 0}, 4000, 0.004, random);
  out.rectangle(2, {0, 0, 0.03}, {3, 0, 0}, {0, 0, 3}, 4000, 0.004, random);
  out.points.push_back({1, 1, 2});
  out.faces.push_back(0);
  return out;
}

}  // namespace

TEST_CASE("assignment__gives_robbed_points_back_to_their_surface") {
  const Scene scene = corner();
  MadeScene made(scene.points);
  auto surfaces = made.surfaces(scene.faces, 2);
  // The wall took every eighth point of the floor.
  std::vector<uint32_t> kept;
  for (size_t i = 0; i < surfaces[0].positions.size(); ++i) {
    const uint32_t p = surfaces[0].positions[i];
    (i % 8 == 0 ? surfaces[1].positions : kept).push_back(p);
    if (i % 8 == 0) made.scene.owner[p] = 2;
  }
  surfaces[0].positions = kept;
  assign_points(made.scene, surfaces, made.task);
  CHECK(made.shared(scene.faces, 1, surfaces[0]) >= 3950);
  CHECK(made.shared(scene.faces, 2, surfaces[1]) >= 3950);
  CHECK(made.shared(scene.faces, 0, surfaces[0]) + made.shared(scene.faces, 0, surfaces[1]) == 0);
  for (size_t s = 0; s < 2; ++s) {
    CHECK(std::is_sorted(surfaces[s].positions.begin(), surfaces[s].positions.end()));
    for (const uint32_t p : surfaces[s].positions) {
      CHECK(made.scene.owner[p] == s + 1);
      CHECK(std::fabs(surfaces[s].plane.distance(made.scene.local(p))) <=
            made.scene.settings.distance_tolerance_m);
    }
  }
}

TEST_CASE("assignment__reaches_no_further_than_the_surfaces_raster_unless_connectivity_is_off") {
  Scene scene;
  RandomStream random(1, 7);
  scene.rectangle(1, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 1000, 0.004, random);
  scene.rectangle(2, {3, 0, 0}, {1, 0, 0}, {0, 1, 0}, 1000, 0.004, random);  // owned by nobody
  for (const bool connectivity : {true, false}) {
    SurfaceSettings settings;
    settings.connectivity = connectivity;
    MadeScene made(scene.points, settings);
    auto surfaces = made.surfaces(scene.faces, 1);
    assign_points(made.scene, surfaces, made.task);
    CHECK(made.shared(scene.faces, 1, surfaces[0]) >= 990);
    if (connectivity) CHECK(made.shared(scene.faces, 2, surfaces[0]) == 0);
    else CHECK(made.shared(scene.faces, 2, surfaces[0]) >= 900);
  }
}

TEST_CASE("assignment__without_surfaces_every_point_is_free") {
  const Scene scene = corner();
  MadeScene made(scene.points);
  made.surfaces(scene.faces, 2);
  std::vector<Surface> none;
  assign_points(made.scene, none, made.task);
  CHECK(std::count(made.scene.owner.begin(), made.scene.owner.end(), 0u) == 8001);
}
