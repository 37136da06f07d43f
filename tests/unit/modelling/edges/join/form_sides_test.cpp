// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// A given form and its sides.
#include "modelling/edges/join/form_sides.h"

#include <doctest/doctest.h>

using namespace jalon;

namespace {

// A window with a flat arch, the wall about it to the left of each edge: up the left jamb, along the head, down, back.
VectorRing arched() {
  VectorRing ring;
  ring.corners = {{1, 0.5}, {1, 2}, {2, 2}, {2, 0.5}};
  ring.edges.resize(4);
  for (VectorEdge& edge : ring.edges) edge.sigma_m = 0.01;
  ring.edges[1].sagitta_m = -0.2;
  return ring;
}

}  // namespace

TEST_CASE("form_sides__are_the_straight_upright_and_level_edges_as_the_form_has_them") {
  VectorRing gable = arched();
  gable.edges[1].sagitta_m = 0;
  gable.corners[2].v = 2.3;
  for (const VectorRing& form : {arched(), gable}) {
    const auto sides = sides_of(form);
    REQUIRE(sides.size() == 4);
    CHECK(sides[1].shape.length_m == 0);
    CHECK(sides[0].shape.length_m == doctest::Approx(1.5));
    CHECK(sides[0].shape.direction == EdgeDirection::kVertical);
    CHECK(sides[3].shape.direction == EdgeDirection::kHorizontal);
    CHECK(sides[3].shape.sigma_m == 0.01);
    const VectorRing same = with_sides(form, sides);
    CHECK(same.corners == form.corners);
    CHECK(same.edges[1].sagitta_m == form.edges[1].sagitta_m);
  }
}

TEST_CASE("form_sides__moved_ones_take_their_ends_along") {
  auto sides = sides_of(arched());
  sides[0].shape.shift(0.02);  // into the wall: to the left
  sides[0].shape.source = EdgeSource::kReveal;
  sides[0].shape.sigma_m = 0.001;
  sides[3].shape.shift(-0.03);
  const VectorRing moved = with_sides(arched(), sides);
  const std::vector<Vec2> wanted{{0.98, 0.53}, {0.98, 2}, {2, 2}, {2, 0.53}};
  for (size_t k = 0; k < 4; ++k) {
    CAPTURE(k);
    CHECK(norm(moved.corners[k] - wanted[k]) < 1e-12);
  }
  CHECK(moved.edges[0].source == EdgeSource::kReveal);
  CHECK(moved.edges[0].sigma_m == 0.001);
  CHECK(moved.edges[2].source == EdgeSource::kContour);
  CHECK(moved.edges[1].sagitta_m == arched().edges[1].sagitta_m);
}

TEST_CASE("form_sides__that_pass_each_other_leave_the_form_as_it_is") {
  auto sides = sides_of(arched());
  sides[0].shape.shift(-1.2);
  CHECK(with_sides(arched(), sides).corners == arched().corners);
}
