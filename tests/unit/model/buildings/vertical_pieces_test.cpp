// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "model/buildings/vertical_pieces.h"

#include <doctest/doctest.h>

#include "unit/model/buildings/houses.h"

using namespace jalon;

TEST_CASE("vertical_pieces__of_a_house__are_its_walls_and_belong_to_its_highest_building") {
  Model model;
  add_house(model, {{0, 0, 0}}, "whole");
  Part wing;
  wing.name = "wing", wing.part_class = "building", wing.parent = 0;
  model.parts.push_back(wing);
  add_wall(model, {{0, 20, 0}, {5, 20, 0}, {5, 20, 3}, {0, 20, 3}}, 1, true);
  const VerticalPieces made = vertical_pieces(model, 0.05);
  CHECK(made.pieces.size() == 5);  // no roof, no floor
  CHECK(made.buildings == std::vector<std::string>{"whole"});
}

TEST_CASE("vertical_pieces__that_lean__are_upright_within_the_tilt") {
  Model model;
  model.parts.push_back({"wall", "mesh", kNoParent});
  add_wall(model, {{0, 0, 0}, {5, 0, 0}, {5, 0.3, 3}, {0, 0.3, 3}}, 0, true);  // 0.1 rad
  CHECK(vertical_pieces(model, 0.09).pieces.empty());
  REQUIRE(vertical_pieces(model, 0.11).pieces.size() == 1);
  CHECK(vertical_pieces(model, 0.11).pieces[0].normal == Vec3{0, -1, 0});
}

TEST_CASE("vertical_pieces__without_building_parts__are_of_what_hangs_together") {
  Model model;
  add_house(model, {{0, 0, 0}}, "a", false);
  add_house(model, {{30, 0, 0}}, "b", false);
  const VerticalPieces made = vertical_pieces(model, 0.05);
  CHECK(made.buildings == std::vector<std::string>{"building 1", "building 2"});
  CHECK(made.pieces.size() == 16);
}
