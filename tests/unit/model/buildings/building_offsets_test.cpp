// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "model/buildings/building_offsets.h"

#include <doctest/doctest.h>

#include "base/error.h"
#include "model/buildings/building_tree.h"
#include "unit/model/buildings/houses.h"

using namespace jalon;

namespace {

Model two_houses_in_strips() {
  Model model;
  add_house(model, {{0, 0, 0}}, "one");
  add_house(model, {{30, 0, 0}}, "two");
  Task task;
  return strip_model(building_tree(model, {}, task));
}

}  // namespace

TEST_CASE("moved_strips__by_offsets__stand_off_by_their_sum_along_the_normal") {
  const Model strips = two_houses_in_strips();
  const BuildingOffsets drawn = drawn_offsets(strips, {1, 0.5, 0.3, 4});
  REQUIRE(drawn.blocks.size() == 2);
  REQUIRE(drawn.facades.size() == 8);
  REQUIRE(drawn.strips.size() == strips.faces.size());
  const Model moved = moved_strips(strips, drawn);
  validate(moved);
  for (size_t f = 0; f < strips.faces.size(); ++f) {
    const Face &was = strips.faces[f], &is = moved.faces[f];
    const size_t facade = strips.parts[was.part].parent - 4;  // behind two blocks, two buildings
    const Vec2& b = drawn.blocks[facade / 4];
    const double off =
        dot(was.plane.normal, {b.u, b.v, 0}) + drawn.facades[facade] + drawn.strips[f];
    CHECK(is.plane.offset - was.plane.offset == doctest::Approx(off));
    const Vec3 corner = moved.vertices[moved.corners[moved.rings[is.first_ring].first]];
    CHECK(std::fabs(is.plane.distance(corner)) < 1e-12);
  }
}

TEST_CASE("drawn_offsets__have_their_sigmas_and_streams_of_their_own") {
  const Model strips = two_houses_in_strips();
  double sum2 = 0;
  size_t n = 0;
  for (uint64_t seed = 0; seed < 300; ++seed)
    for (const double o : drawn_offsets(strips, {1, 0.5, 0.3, seed}).strips) sum2 += o * o, ++n;
  CHECK(std::sqrt(sum2 / static_cast<double>(n)) == doctest::Approx(0.3).epsilon(0.02).scale(0));
  // Blocks that do not move change nothing of the others.
  CHECK(drawn_offsets(strips, {0, 0.5, 0.3, 7}).facades ==
        drawn_offsets(strips, {1, 0.5, 0.3, 7}).facades);
}

TEST_CASE("moved_strips__of_another_model__is_refused") {
  Model model;
  add_house(model, {{0, 0, 0}}, "one");
  CHECK_THROWS_AS(moved_strips(model, drawn_offsets(model, {})), Error);
}

TEST_CASE("moved_strips__with_roofs__take_them_along_with_their_block") {
  Model model;
  add_house(model, {{0, 0, 0}}, "one");
  Task task;
  const BuildingTree tree = building_tree(model, {}, task);
  Model strips = strip_model(tree);
  const size_t walls = strips.faces.size();
  add_others(strips, tree, model);
  validate(strips);
  REQUIRE(strips.faces.size() == walls + 2);  // roof and floor
  BuildingOffsets offsets = drawn_offsets(strips, {1, 0.5, 0.3, 4});
  const Model moved = moved_strips(strips, offsets);
  for (size_t f = walls; f < strips.faces.size(); ++f) {
    const uint32_t corner = strips.corners[strips.rings[strips.faces[f].first_ring].first];
    const Vec3 by = moved.vertices[corner] - strips.vertices[corner];
    CHECK(by.x == doctest::Approx(offsets.blocks[0].u));
    CHECK(by.y == doctest::Approx(offsets.blocks[0].v));
  }
}
