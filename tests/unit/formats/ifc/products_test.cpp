// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/ifc/products.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <string>

#include "model/chords.h"
#include "unit/formats/house.h"

using namespace jalon;
using namespace jalon::ifc;

namespace {

size_t part_named(const Model& model, const std::string& name) {
  for (size_t p = 0; p < model.parts.size(); ++p)
    if (model.parts[p].name == name) return p;
  REQUIRE(false);
  return 0;
}

}  // namespace

TEST_CASE("ifc_products__openings_have_their_wall_and_show_the_joinery_that_stands_in_them") {
  const Model model = with_chords(test::House().model(), 0.001);  // a circle has two corners
  const Products products = arrange_products(model);
  const size_t window = part_named(model, "window 1"),
               wall = part_named(model, "wall \xC3\xA9t\xC3\xA9");
  CHECK(products.roles[window] == Role::kOpening);
  CHECK(products.hosts[window] == wall);
  CHECK(products.holes[window].size() == 1);
  CHECK(products.shapes[window].faces.size() == 1);
  CHECK(products.roles[part_named(model, "joinery 1")] == Role::kWithin);
  CHECK(products.roles[part_named(model, "round")] == Role::kOpening);
  CHECK(products.shapes[part_named(model, "round")].empty());
  CHECK(products.roles[part_named(model, "house")] == Role::kBuilding);
  CHECK(products.roles[part_named(model, "sill 1")] == Role::kElement);
  CHECK(products.shapes[part_named(model, "sill 1")].solids.size() == 1);
  CHECK(products.buildings[wall] == part_named(model, "house"));
}

TEST_CASE("ifc_products__a_facade_groups_what_is_straight_below_it") {
  const Model model = test::House().model();
  const Products products = arrange_products(model);
  const size_t facade = part_named(model, "facade A");
  CHECK(products.roles[facade] == Role::kGroup);
  // The wall, and what hangs on it: no group stands between.
  const auto& members = products.members[facade];
  CHECK(std::find(members.begin(), members.end(), part_named(model, "wall \xC3\xA9t\xC3\xA9")) !=
        members.end());
  CHECK(std::find(members.begin(), members.end(), part_named(model, "roof")) == members.end());
}

TEST_CASE("ifc_products__parts_whose_parents_go_in_a_ring_come_to_an_end") {
  Model model = test::House().model();
  model.parts[0].parent = 2;
  const Products products = arrange_products(model);
  CHECK(products.roles[2] == Role::kElement);
}

TEST_CASE("ifc_products__classes_that_ifc_does_not_know_are_proxies") {
  CHECK(std::string(entity_of("window").name) == "IFCWINDOW");
  CHECK(std::string(entity_of("gateway").type) == "GATE");
  CHECK(std::string(entity_of("gargoyle").name) == "IFCBUILDINGELEMENTPROXY");
}
