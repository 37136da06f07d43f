// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "model/buildings/facades.h"

#include <doctest/doctest.h>

#include "unit/model/buildings/houses.h"

using namespace jalon;

TEST_CASE("facades__of_a_single_wall__keep_the_side_that_they_have") {
  Model model;
  model.parts.push_back({"wall", "mesh", kNoParent});
  add_wall(model, {{0, 0, 0}, {0, 5, 0}, {0, 5, 3}, {0, 0, 3}}, 0, false);
  std::vector<BuildingFacade> facades = facades_of(vertical_pieces(model, 0.1), 0.1);
  REQUIRE(facades.size() == 1);
  turn_outward(facades);
  CHECK(norm(facades[0].normal - Vec3{1, 0, 0}) < 1e-15);
  CHECK(facades[0].from_m == 0);
  CHECK(facades[0].to_m == 5);
  CHECK(norm(facades[0].place({2, 1}) - Vec3{0, 2, 1}) < 1e-15);
}

TEST_CASE("facades__shorter_than_asked__are_left_out") {
  Model model;
  add_house(model, {{0, 0, 0}, {1, 0, 0}, 10, 0.3, 5, 0}, "narrow");
  CHECK(facades_of(vertical_pieces(model, 0.1), 0.1).size() == 4);
  CHECK(facades_of(vertical_pieces(model, 0.1), 0.5).size() == 2);
}

TEST_CASE("facades__of_triangles_in_one_plane_but_apart__are_two") {
  Model model;
  model.parts.push_back({"walls", "mesh", kNoParent});
  add_wall(model, {{0, 0, 0}, {5, 0, 0}, {5, 0, 3}, {0, 0, 3}}, 0, false);
  add_wall(model, {{5, 0, 0}, {6, 1, 0}, {6, 1, 3}, {5, 0, 3}}, 0, false);
  add_wall(model, {{6, 1, 0}, {7, 0, 0}, {7, 0, 3}, {6, 1, 3}}, 0, false);
  add_wall(model, {{7, 0, 0}, {9, 0, 0}, {9, 0, 3}, {7, 0, 3}}, 0, false);
  CHECK(facades_of(vertical_pieces(model, 0.1), 0.1).size() == 4);
}
