// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "model/buildings/given_strips.h"

#include <doctest/doctest.h>

#include "model/buildings/building_offsets.h"
#include "model/buildings/part_numbers.h"
#include "unit/model/buildings/houses.h"

using namespace jalon;

namespace {

// On a national grid and turned: a house with gables beside one without, and one across the street.
Model street_in_strips(bool others, StripTop top = StripTop::kRectangle) {
  constexpr Vec3 kCorner{652000.25, 6861000.5, 35}, kWay{0.6, 0.8, 0};
  Model model;
  add_house(model, {kCorner, kWay, 10, 8, 6, 3}, "barn");
  add_house(model, {kCorner + kWay * 10, kWay, 12, 8, 7, 0}, "house");
  add_house(model, {kCorner + Vec3{0, 40, 0}, kWay, 9, 8, 6, 0}, "school");
  BuildingSettings settings;
  settings.top = top;
  Task task;
  const BuildingTree tree = building_tree(model, settings, task);
  Model made = strip_model(tree);
  if (others) add_others(made, tree, model);
  return made;
}

Model again(const Model& strips, double width_m = 1.5) {
  BuildingSettings settings;
  settings.width_m = width_m;
  Task task;
  const BuildingTree tree = building_tree(strips, settings, task);
  Model made = strip_model(tree);
  add_others(made, tree, strips);
  return made;
}

void check_same(const Model& was, const Model& is, double off_m) {
  REQUIRE(is.faces.size() == was.faces.size());
  const auto before = part_numbers(was), after = part_numbers(is);
  for (size_t f = 0; f < was.faces.size(); ++f) {
    const Face &a = was.faces[f], &b = is.faces[f];
    CHECK(after[b.part].block == before[a.part].block);
    CHECK(after[b.part].facade == before[a.part].facade);
    CHECK(after[b.part].strip == before[a.part].strip);
    REQUIRE(is.rings[b.first_ring].count == was.rings[a.first_ring].count);
    for (uint64_t c = 0; c < was.rings[a.first_ring].count; ++c) {
      const Vec3& p = was.vertices[was.corners[was.rings[a.first_ring].first + c]];
      const Vec3& q = is.vertices[is.corners[is.rings[b.first_ring].first + c]];
      CHECK(norm(p - q) < off_m);
    }
  }
}

}  // namespace

TEST_CASE("given_strips__of_moved_strips__keep_numbers_and_places") {
  constexpr double kRounding_m = 1e-8;  // of coordinates of seven digits, turned there and back
  for (const StripTop top : {StripTop::kRectangle, StripTop::kClip}) {
    const Model strips = street_in_strips(true, top);
    const Model moved = moved_strips(strips, drawn_offsets(strips, {1, 0.5, 0.3, 21}));
    check_same(moved, again(moved), kRounding_m);
  }
}

TEST_CASE("given_strips__with_a_rounded_file__stay_within_its_step") {
  Model strips = street_in_strips(true);
  strips = moved_strips(strips, drawn_offsets(strips, {1, 0.5, 0.3, 22}));
  constexpr double kStep_m = 1e-4;  // of CityJSON files
  Model rounded = strips;
  for (Vec3& p : rounded.vertices)
    for (int k = 0; k < 3; ++k) p[k] = std::round(p[k] / kStep_m) * kStep_m;
  check_same(strips, again(rounded), 2 * kStep_m);
}

TEST_CASE("given_strips__of_other_widths_asked_for__stay_as_they_are") {
  const Model strips = street_in_strips(false);
  CHECK(again(strips, 0.7).faces.size() == strips.faces.size());
}

TEST_CASE("is_of_strips__asks_for_facade_building_and_block_above_each") {
  Model strips = street_in_strips(false);
  CHECK(is_of_strips(strips));
  Model houses;
  add_house(houses, {{0, 0, 0}}, "one");
  CHECK(!is_of_strips(houses));
  // A building, a facade or a strip that stands below none.
  for (const char* part_class : {"building", "facade", "strip"}) {
    Model more = strips;
    more.parts.push_back({"lost", part_class, kNoParent});
    CHECK(!is_of_strips(more));
  }
  for (Part& part : strips.parts)
    if (part.part_class == "block") part.part_class = "quarter";
  CHECK(!is_of_strips(strips));
}

TEST_CASE("is_of_strips__with_strips_that_lean_or_look_elsewhere__says_no") {
  const Model strips = street_in_strips(false);
  for (const Vec3& normal : {Vec3{0, 0.6, 0.8}, strips.faces[3].plane.normal * -1, Vec3{}}) {
    Model other = strips;
    other.faces[3].plane.normal = normal;
    CHECK(!is_of_strips(other));
  }
}
