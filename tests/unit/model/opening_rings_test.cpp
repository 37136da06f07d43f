// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// Where openings are drawn, on a model made by hand: a hole of a wall, a face of its own, joinery alone, nothing.
#include "model/opening_rings.h"

#include <doctest/doctest.h>

#include "model/part_classes.h"

using namespace jalon;

namespace {

std::vector<Vec3> square(double x, double side) {
  return {{x, 0, 0}, {x + side, 0, 0}, {x + side, 0, side}, {x, 0, side}};
}

}  // namespace

TEST_CASE("opening_rings__are_holes_else_own_faces_else_those_of_the_joinery") {
  Model model;
  model.parts = {{"wall", "wall", kNoParent},      {"window", "window", 0}, {"pane", "joinery", 1},
                 {"gate", "gateway", 0},           {"door", "door", 0},     {"leaf", "joinery", 4},
                 {"side", part_class::kReveal, 4}, {"vent", "vent", 0},     {"dark", "no_data", 0}};
  const auto add = [&](uint32_t part, double x) {
    Face face;
    face.part = part;
    return model.add_face(face, {square(x, 1)});
  };
  Face wall;
  const size_t front = model.add_face(wall, {square(0, 9), square(1, 1), square(6, 1)});
  model.rings[model.faces[front].first_ring + 1].part = 1;
  model.rings[model.faces[front].first_ring + 2].part = 8;
  add(2, 1);
  const size_t own = add(3, 3);
  add(6, 5);
  const size_t leaf = add(5, 5);
  const auto rings = opening_rings(model);
  REQUIRE(rings.size() == model.parts.size());
  REQUIRE(rings[1].size() == 1);  // the pane behind the hole is not it
  CHECK(rings[1][0].face == front);
  CHECK(rings[1][0].ring == model.faces[front].first_ring + 1);
  CHECK(has_own_ring(model, 1, rings[1]));
  REQUIRE(rings[3].size() == 1);
  CHECK(rings[3][0].face == own);
  CHECK(has_own_ring(model, 3, rings[3]));
  REQUIRE(rings[4].size() == 1);  // the reveal left out
  CHECK(rings[4][0].face == leaf);
  CHECK_FALSE(has_own_ring(model, 4, rings[4]));
  CHECK(rings[7].empty());
  CHECK_FALSE(has_own_ring(model, 7, rings[7]));
  for (const size_t other : {0, 2, 5, 6, 8}) CHECK(rings[other].empty());
}
