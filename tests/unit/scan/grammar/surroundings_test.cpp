// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include "scan/grammar/realise.h"
#include "unit/scan/grammar/facades.h"

using namespace jalon;
using namespace jalon::test;
using namespace jalon::grammar;

TEST_CASE("surroundings__pavement_kerb_and_road_lie_before_the_wall") {
  SceneBuilder out{Transform{}};
  const Plan plan = planned(FacadeKind::kTownHouse, 1);
  add_ground(plan, 15, out);
  const Model model = out.take();
  CHECK(top_z(model, 3, -1) == doctest::Approx(0));
  CHECK(top_z(model, 3, 1) == doctest::Approx(0));  // the floor behind
  CHECK(top_z(model, 3, -5) == doctest::Approx(-0.12).scale(0));
  CHECK(top_z(model, 3, -14.9) == doctest::Approx(-0.12).scale(0));
  CHECK(std::isinf(top_z(model, 3, -15.1)));
  for (const Face& face : model.faces) CHECK(is_sound(model, face));
}

TEST_CASE("surroundings__rooms_have_a_back_wall_and_a_floor_a_storey_that_churches_lack") {
  for (const FacadeKind kind : {FacadeKind::kTownHouse, FacadeKind::kChurch}) {
    SceneBuilder out{Transform{}};
    const Plan plan = planned(kind, 1);
    add_rooms(plan, out);
    const Model model = out.take();
    CHECK(front_y(model, 3, 1) == doctest::Approx(plan.rooms_to_m));
    const size_t slabs = kind == FacadeKind::kChurch ? 0 : plan.floors_m.size() - 1;
    CHECK(model.faces.size() == 3 + slabs);
    // None looks over the lowest eaves.
    for (const Vec3& p : model.vertices) CHECK(p.z <= plan.walls[0].outline[2].at.v + kRounding_m);
  }
}

TEST_CASE("surroundings__what_stands_in_the_way_stands_before_the_wall_and_changes_with_the_seed") {
  const Plan plan = planned(FacadeKind::kOffices, 1);
  size_t trees = 0, cars = 0, people = 0, posts = 0;
  std::vector<Vec3> before;
  for (uint64_t seed = 1; seed <= 20; ++seed) {
    SceneBuilder out{Transform{}};
    add_occluders(plan, seed, out);
    const Model model = out.take();
    for (const Vec3& p : model.vertices) {
      REQUIRE(p.y < -0.2);
      REQUIRE(p.y > -8);
    }
    trees += parts_named(model, "tree").size();
    cars += parts_named(model, "car").size();
    people += parts_named(model, "pedestrian").size();
    posts += parts_named(model, "post").size();
    if (!model.vertices.empty() && !before.empty()) CHECK(model.vertices != before);
    before = model.vertices;
  }
  CHECK(trees > 5);
  CHECK(cars > 5);
  CHECK(people > 10);
  CHECK(posts > 5);
}
