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

TEST_CASE("assignment__a_later_round_gives_what_sharing_out_all_points_gives") {
  Scene scene = corner();
  RandomStream random(2, 7);
  scene.rectangle(3, {8, 0, 0}, {3, 0, 0}, {0, 3, 0}, 4000, 0.004, random);
  scene.rectangle(4, {8, 0, 0.01}, {3, 0, 0}, {0, 0, 3}, 4000, 0.004, random);
  MadeScene made(scene.points);
  std::vector<Surface> surfaces = made.surfaces(scene.faces, 4);
  Assignment rounds;
  const auto to_fixed_point = [&] {
    std::vector<uint32_t> before;
    for (int round = 0; round < 20 && made.scene.owner != before; ++round) {
      before = made.scene.owner;
      for (Surface& surface : surfaces) surface.sharing.fresh = true;
      rounds.next_round(made.scene, surfaces, made.task);
    }
    REQUIRE(made.scene.owner == before);
  };
  to_fixed_point();
  const auto check_round = [&] {
    std::vector<Surface> again = surfaces;
    rounds.next_round(made.scene, surfaces, made.task);
    const std::vector<uint32_t> owner = made.scene.owner;
    assign_points(made.scene, again, made.task);
    CHECK(owner == made.scene.owner);
    for (size_t s = 0; s < surfaces.size(); ++s) CHECK(surfaces[s].positions == again[s].positions);
  };
  // 1. A plane that moved away from its points, and one that took over from it.
  const size_t before = surfaces[0].positions.size();
  surfaces[0].plane.offset += 0.012;
  surfaces[0].sharing.fresh = true;
  check_round();
  CHECK(surfaces[0].positions.size() != before);
  to_fixed_point();
  // 2. One that was dropped: the numbers behind it are others now, and its points are free or its neighbour's.
  for (const uint32_t position : surfaces[1].positions) made.scene.owner[position] = 0;
  surfaces.erase(surfaces.begin() + 1);
  check_round();
  CHECK(made.shared(scene.faces, 4, surfaces[2]) >= 3900);
  to_fixed_point();
  // 3. One that came.
  Surface half = surfaces[1];
  half.positions.resize(half.positions.size() / 2);
  half.plane.offset += 0.004;
  half.sharing = {};
  surfaces.push_back(half);
  check_round();
  CHECK(surfaces[3].positions.size() > 100);
}

TEST_CASE("assignment__counts_the_points_that_came_or_went") {
  const Scene scene = corner();
  MadeScene made(scene.points);
  std::vector<Surface> surfaces = made.surfaces(scene.faces, 2);
  Assignment rounds;
  rounds.next_round(made.scene, surfaces, made.task);
  CHECK(surfaces[0].sharing.moved == Surface::Sharing::kAll);
  for (Surface& surface : surfaces) surface.sharing.moved = 0;
  const std::vector<uint32_t> before = made.scene.owner;
  surfaces[1].plane.offset += 0.01;
  surfaces[1].sharing.fresh = true;
  rounds.next_round(made.scene, surfaces, made.task);
  size_t moved[3] = {0, 0, 0};
  for (size_t i = 0; i < before.size(); ++i)
    if (made.scene.owner[i] != before[i]) ++moved[before[i]], ++moved[made.scene.owner[i]];
  CHECK(moved[2] > 0);
  CHECK(surfaces[0].sharing.moved == moved[1]);
  CHECK(surfaces[1].sharing.moved == moved[2]);
}
