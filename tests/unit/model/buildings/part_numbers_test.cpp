// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "model/buildings/part_numbers.h"

#include <doctest/doctest.h>

#include "model/buildings/building_tree.h"
#include "unit/model/buildings/houses.h"

using namespace jalon;

TEST_CASE("part_numbers__of_a_model_of_strips__are_those_of_its_tree") {
  Model model;
  add_house(model, {{0, 0, 0}}, "one");
  add_house(model, {{30, 0, 0}}, "two");
  Task task;
  const BuildingTree tree = building_tree(model, {}, task);
  const Model strips = strip_model(tree);
  const std::vector<PartNumbers> numbers = part_numbers(strips);
  for (const Face& face : strips.faces) {
    const PartNumbers& n = numbers[face.part];
    CHECK(n.strip == face.id);
    CHECK(n.facade == tree.strips[face.id].facade);
    CHECK(n.block == tree.block_of(tree.facades[n.facade]));
  }
  CHECK(numbers[0].facade == ~0u);  // a block has no facade above it
  CHECK(numbers[0].block == 0);
}
