// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "model/buildings/building_tree.h"

#include <doctest/doctest.h>

#include <numbers>
#include <string>

#include "base/error.h"
#include "unit/model/buildings/houses.h"

using namespace jalon;

namespace {

constexpr Vec3 kTown{652000.25, 6861000.5, 35};

BuildingTree tree_of(const Model& model, const BuildingSettings& settings = {}) {
  Task task;
  return building_tree(model, settings, task);
}

// Two houses wall to wall and one across a street of 12 m.
Model three_houses(bool as_faces) {
  Model model;
  add_house(model, {kTown}, "one", as_faces);
  add_house(model, {kTown + Vec3{10, 0.4, 0}}, "two", as_faces);
  add_house(model, {kTown + Vec3{20, -12, 0}, {-1, 0, 0}, 20, 8, 9, 0}, "three", as_faces);
  return model;
}

}  // namespace

TEST_CASE("building_tree__of_faces__has_blocks_buildings_facades_and_strips") {
  const Model model = three_houses(true);
  const BuildingTree tree = tree_of(model);
  CHECK(tree.blocks == 2);
  CHECK(tree.buildings == std::vector<std::string>{"one", "two", "three"});
  CHECK(tree.block_of_building == std::vector<uint32_t>{0, 0, 1});
  REQUIRE(tree.facades.size() == 12);
  for (const BuildingFacade& f : tree.facades) CHECK(!f.was_turned);
  CHECK(norm(tree.facades[0].normal - Vec3{0, -1, 0}) < 1e-12);
  CHECK(tree.facades[0].to_m - tree.facades[0].from_m == doctest::Approx(10));
  CHECK(tree.facades[8].top_m == doctest::Approx(44));
  // 10 m: six of 1.5 m and one of 1 m; 8 m: five, the rest of 0.5 m in the last; 20 m: 13.
  CHECK(tree.strips.size() == 2 * (7 + 5 + 7 + 5) + 13 + 5 + 13 + 5);
}

TEST_CASE("building_tree__of_bare_triangles__joins_those_of_a_wall") {
  const BuildingTree tree = tree_of(three_houses(false));
  CHECK(tree.buildings.size() == 3);
  CHECK(tree.facades.size() == 12);
  CHECK(tree.blocks == 2);
}

TEST_CASE("building_tree__with_walls_inside_out__turns_them") {
  Model model = three_houses(true);
  for (Ring& ring : model.rings) {
    const auto first = model.corners.begin() + static_cast<ptrdiff_t>(ring.first);
    if (&ring - model.rings.data() == 2 || &ring - model.rings.data() == 7)
      std::reverse(first, first + static_cast<ptrdiff_t>(ring.count));
  }
  const BuildingTree good = tree_of(three_houses(true)), tree = tree_of(model);
  int turned = 0;
  for (size_t f = 0; f < tree.facades.size(); ++f) {
    turned += tree.facades[f].was_turned;
    CHECK(norm(tree.facades[f].normal - good.facades[f].normal) < 1e-12);
    CHECK(std::fabs(tree.facades[f].from_m - good.facades[f].from_m) < 1e-9);
  }
  CHECK(turned == 2);
}

TEST_CASE("building_tree__of_a_gable__clips_its_strips_to_the_slopes") {
  Model model;
  add_house(model, {kTown, {0.6, 0.8, 0}, 10, 8, 6, 3}, "barn");
  BuildingSettings settings;
  settings.width_m = 2;
  const BuildingTree whole = tree_of(model, settings);
  settings.top = StripTop::kClip;
  const BuildingTree cut = tree_of(model, settings);
  CHECK(cut.strips.size() == whole.strips.size());
  const Model a = strip_model(whole), b = strip_model(cut);
  validate(a);
  validate(b);
  double whole_m2 = 0, cut_m2 = 0;
  for (const Face& f : a.faces) whole_m2 += f.area_m2;
  for (const Face& f : b.faces) cut_m2 += f.area_m2;
  CHECK(whole_m2 == doctest::Approx(2 * 10 * 6 + 2 * 8 * 9));
  CHECK(cut_m2 == doctest::Approx(2 * 10 * 6 + 2 * (8 * 6 + 8 * 3 / 2.0)).epsilon(1e-4));
}

TEST_CASE("strip_model__of_a_tree__lies_in_the_facades_and_looks_outward") {
  const BuildingTree tree = tree_of(three_houses(true));
  const Model model = strip_model(tree);
  validate(model);
  CHECK(model.faces.size() == tree.strips.size());
  CHECK(model.triangles.size() == 2 * tree.strips.size());
  for (size_t t = 0; t < model.triangles.size(); ++t) {
    const uint32_t strip = model.triangle_faces[t];
    const BuildingFacade& facade = tree.facades[tree.strips[strip].facade];
    const Vec3 &p = model.vertices[model.triangles[t][0]],
               &q = model.vertices[model.triangles[t][1]],
               &r = model.vertices[model.triangles[t][2]];
    CHECK(norm(normalized(cross(q - p, r - p)) - facade.normal) < 1e-6);
    CHECK(std::fabs(dot(facade.normal, p) - facade.offset_m) < 1e-8);
    const Part& part = model.parts[model.faces[strip].part];
    CHECK(part.part_class == "strip");
    CHECK(model.parts[part.parent].part_class == "facade");
    CHECK(model.parts[model.parts[part.parent].parent].part_class == "building");
    CHECK(model.parts[model.parts[model.parts[part.parent].parent].parent].part_class == "block");
  }
}

TEST_CASE("building_tree__without_upright_faces__is_refused") {
  Model model;
  Face floor;
  model.parts.push_back({"floor", "ground", kNoParent});
  model.add_face(floor, {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}});
  CHECK_THROWS_AS(tree_of(model), Error);
}

TEST_CASE("building_tree__ten_thousand_times_too_large__says_so_before_it_cuts_strips") {
  Model model = three_houses(true);
  for (Vec3& v : model.vertices) v *= 1e4;
  for (Face& face : model.faces) face.plane.offset *= 1e4, face.area_m2 *= 1e8;
  try {
    tree_of(model);
    FAIL("not refused");
  } catch (const Error& e) {
    CHECK(std::string(e.what()).find("a facade is 100 km long") != std::string::npos);
  }
}
