// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "model/relations/relations.h"

#include <doctest/doctest.h>

#include <atomic>
#include <cstring>

#include "base/error.h"
#include "model/relations/directions.h"
#include "unit/model/relations/boxes.h"

using namespace jalon;
using namespace jalon::test;

namespace {

enum Rows : uint32_t { kFacade, kWall, kWindow, kDoor, kSill, kGround, kPane };

// A wall of 10 x 4 m with a window and a door to its foot, a sill before the window, the ground, a pane behind.
Model house() {
  Model m;
  m.parts = {{"facade", "facade", kNoParent}, {"wall 1", "wall", 0}, {"window 1.1", "window", 1},
             {"door 1", "door", 1},           {"sill 1", "sill", 0}, {"ground 1", "ground", 0},
             {"joinery", "joinery", 2}};
  const auto add = [&](uint32_t part, const std::vector<std::vector<Vec3>>& rings) {
    Face face;
    face.part = part;
    const auto& p = rings[0];
    face.plane.normal = normalized(cross(p[1] - p[0], p[2] - p[0]));
    face.plane.offset = dot(face.plane.normal, p[0]);
    face.area_m2 = 1;
    m.add_face(face, rings);
  };
  add(kWall,
      {{{0, 0, 0}, {6, 0, 0}, {6, 0, 2}, {7, 0, 2}, {7, 0, 0}, {10, 0, 0}, {10, 0, 4}, {0, 0, 4}},
       {{2, 0, 1}, {2, 0, 2.5}, {3.2, 0, 2.5}, {3.2, 0, 1}}});
  m.rings[1].part = kWindow;
  add(kDoor, {{{6, 0, 0}, {7, 0, 0}, {7, 0, 2}, {6, 0, 2}}});
  add(kSill, {{{1.9, -0.1, 0.9}, {3.3, -0.1, 0.9}, {3.3, -0.1, 0.98}, {1.9, -0.1, 0.98}}});
  add(kGround, {{{-1, -3, 0}, {11, -3, 0}, {11, 0, 0}, {-1, 0, 0}}});
  add(kPane, {{{2, 0.2, 1}, {3.2, 0.2, 1}, {3.2, 0.2, 2.5}, {2, 0.2, 2.5}}});
  return m;
}

std::vector<Relation> relations_of(const Model& model, const RelationSettings& settings = {},
                                   unsigned threads = 2) {
  Task::Hooks hooks;
  hooks.threads = threads;
  Task task(hooks);
  return find_relations(model, settings, task);
}

const Relation& between(const std::vector<Relation>& all, uint32_t first, uint32_t second) {
  for (const Relation& r : all)
    if (r.first == first && r.second == second) return r;
  FAIL("no such pair: " << first << " " << second);
  return all[0];
}

std::string word(const Relation& r) { return name_of(relation_of(r.matrix)); }

}  // namespace

TEST_CASE("relations__of_parts_as_somebody_before_the_facade_sees_them") {
  const auto all = relations_of(house());
  CHECK(word(between(all, kWall, kWindow)) == "contains");
  CHECK(word(between(all, kWall, kDoor)) == "covers");  // it stands on the wall's foot
  CHECK(word(between(all, kFacade, kWall)) == "equal");
  CHECK(word(between(all, kWindow, kPane)) == "equal");
  CHECK(between(all, kWindow, kPane).direction == kBehind);  // what lies in both counts for neither
  CHECK(word(between(all, kWall, kSill)) == "contains");
  CHECK(between(all, kWall, kSill).direction == kBefore);
  CHECK(between(all, kWall, kSill).distance_m == doctest::Approx(0.1));
  CHECK(between(all, kWall, kSill).offset_m.z ==
        doctest::Approx(0.2));  // of the middles: the wall has the pane
  CHECK((between(all, kWindow, kSill).direction & (kBelow | kBefore)) == (kBelow | kBefore));
  // Edge-on, the ground has no area there: as surfaces both meet along the wall's foot and the door's.
  const Relation& foot = between(all, kWall, kGround);
  CHECK(word(foot) == "meet");
  CHECK(foot.matrix.at(NineIntersection::kBoundary, NineIntersection::kBoundary) == 1);
  CHECK(foot.matrix.at(NineIntersection::kExterior, NineIntersection::kExterior) == 3);
  CHECK(foot.distance_m == 0);
  CHECK((foot.direction & kBelow) != 0);
}

TEST_CASE("relations__pairs_further_apart_than_asked_are_left_out") {
  const auto has_pair = [](double most_m) {
    for (const Relation& r : relations_of(house(), {.max_distance_m = most_m}))
      if (r.first == kWindow && r.second == kDoor) return true;
    return false;
  };
  CHECK(!has_pair(2.79));
  CHECK(has_pair(2.81));
  const auto all = relations_of(house(), {.max_distance_m = 5});
  const Relation& r = between(all, kWindow, kDoor);
  CHECK(word(r) == "disjoint");
  CHECK(r.distance_m == doctest::Approx(2.8));
  CHECK((r.direction & (kLeft | kRight | kBelow | kAbove)) == kRight);
  CHECK(r.offset_m.x == doctest::Approx(6.5 - 2.6));
  CHECK(r.offset_m.y == doctest::Approx(1 - 1.75));
}

TEST_CASE("relations__of_faces_and_of_solids") {
  const Model model = house();
  const auto faces = relations_of(model, {.elements = RelationSettings::Elements::kFaces});
  CHECK(word(between(faces, 0, 1)) == "meet");  // the door fills the notch of the wall
  CHECK(word(between(faces, 0, 3)) == "meet");
  CHECK(between(faces, 0, 4).distance_m == doctest::Approx(0.2));
  CHECK(between(faces, 0, 4).direction == kBehind);
  Model blocks;
  add_box(blocks, {0, 0, 0}, {4, 1, 3});
  add_box(blocks, {4, 0, 0}, {6, 1, 3});
  add_box(blocks, {1, 0.2, 1}, {2, 0.8, 2});
  const auto solids = relations_of(blocks, {.elements = RelationSettings::Elements::kSolids});
  CHECK(word(between(solids, 0, 1)) == "meet");
  CHECK(word(between(solids, 0, 2)) == "contains");
  CHECK(solids.size() == 2);  // the inner block is 2 m from the other
}

TEST_CASE("relations__wherever_the_house_stands_and_whichever_way_it_looks") {
  const auto here = relations_of(house());
  Model there = house();
  const double c = std::cos(2.1), s = std::sin(2.1);
  const Transform T{{c, -s, 0, 652000, s, c, 0, 6861000, 0, 0, 1, 40}};
  for (Vec3& p : there.vertices) p = T.point(p);
  for (Face& f : there.faces) {
    f.plane.normal = T.direction(f.plane.normal);
    f.plane.offset =
        dot(f.plane.normal, there.vertices[there.corners[there.rings[f.first_ring].first]]);
  }
  const auto moved = relations_of(there);
  REQUIRE(moved.size() == here.size());
  for (size_t i = 0; i < here.size(); ++i) {
    CAPTURE(here[i].first);
    CAPTURE(here[i].second);
    CHECK(moved[i].first == here[i].first);
    CHECK(moved[i].second == here[i].second);
    CHECK(moved[i].matrix == here[i].matrix);
    CHECK(moved[i].direction == here[i].direction);
    CHECK(std::fabs(moved[i].distance_m - here[i].distance_m) < 1e-6);
    CHECK(norm(moved[i].offset_m - here[i].offset_m) < 1e-6);
  }
}

TEST_CASE("relations__same_for_any_number_of_threads_and_refusals_say_why") {
  const auto one = relations_of(house(), {}, 1), five = relations_of(house(), {}, 5);
  REQUIRE(one.size() == five.size());
  for (size_t i = 0; i < one.size(); ++i) {
    CHECK(one[i].first == five[i].first);
    CHECK(one[i].second == five[i].second);
    CHECK(one[i].matrix == five[i].matrix);
    CHECK(one[i].distance_m == five[i].distance_m);
  }
  CHECK_THROWS_WITH_AS(relations_of(house(), {.elements = RelationSettings::Elements::kSolids}),
                       doctest::Contains("no solids"), Error);
  CHECK_THROWS_WITH_AS(relations_of(Model{}), doctest::Contains("no faces"), Error);
  std::atomic<bool> cancel{true};
  Task::Hooks hooks;
  hooks.cancel = &cancel;
  Task task(hooks);
  CHECK_THROWS_AS(find_relations(house(), {}, task), Error);
}

TEST_CASE("relations__table_has_a_row_a_pair_in_the_order_of_the_columns") {
  const auto all = relations_of(house());
  const FieldTable table = relation_table(all);
  const auto matrix = table.require("matrix").values<int8_t>();
  const auto relation = table.require("relation").values<uint8_t>();
  REQUIRE(relation.size() == all.size());
  for (size_t i = 0; i < all.size(); ++i) {
    CHECK(relation[i] == static_cast<uint8_t>(relation_of(all[i].matrix)));
    CHECK(std::memcmp(&matrix[9 * i], all[i].matrix.dimensions.data(), 9) == 0);
    if (i > 0)
      CHECK(std::pair(all[i - 1].first, all[i - 1].second) <
            std::pair(all[i].first, all[i].second));
  }
}
