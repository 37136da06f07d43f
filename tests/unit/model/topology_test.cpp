// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "model/topology.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace jalon;

namespace {

// Two squares that share the edge from vertex 1 to vertex 2; the second walks it the other way.
Model two_squares(double sagitta_m) {
  Model model;
  model.vertices = {{0, 0, 0}, {1, 0, 0}, {1, 0, 1}, {0, 0, 1}, {2, 0, 0}, {2, 0, 1}};
  model.corners = {0, 1, 2, 3, 1, 4, 5, 2};
  model.sagittas = {0, sagitta_m, 0, 0, 0, 0, 0, -sagitta_m};
  model.rings = {{0, 4}, {4, 4}};
  model.faces.resize(2);
  model.faces[0].ring_count = 1;
  model.faces[1].first_ring = 1;
  model.faces[1].ring_count = 1;
  return model;
}

}  // namespace

TEST_CASE(
    "topology: an edge of two faces is there once, with both faces and the sagitta of the first") {
  const auto edges = find_edges(two_squares(0.1));
  REQUIRE(edges.size() == 7);
  const Edge& shared = edges[2];
  CHECK(shared.from == 1);
  CHECK(shared.to == 2);
  CHECK(shared.first_face == 0);
  CHECK(shared.second_face == 1);
  CHECK(shared.uses == 2);
  CHECK(shared.sagitta_m == 0.1);
  CHECK(edges[0].second_face == kNoFace);
}

TEST_CASE(
    "topology: an arc by end points and sagitta has its circle's centre and radius, right of the "
    "walk") {
  const Arc2 half = arc_of({0, 0}, {2, 0}, 1);
  CHECK(half.radius == doctest::Approx(1));
  CHECK(half.bulge == doctest::Approx(1));
  CHECK(norm(half.centre - Vec2{1, 0}) < 1e-15);
  std::vector<Vec2> chords;
  append_arc(chords, {0, 0}, {2, 0}, 1, 1e-3);
  double lowest = 0;
  for (const Vec2& p : chords) {
    CHECK(norm(p - half.centre) == doctest::Approx(1));
    lowest = std::min(lowest, p.v);
  }
  CHECK(lowest < -0.99);  // anticlockwise from left to right runs below
}

TEST_CASE("topology: chords stay within their error, above a half circle too, on either side") {
  for (const double sagitta : {0.3, -0.3, 1.6, -1.6}) {
    const Vec2 a{3, -2}, b{4, 0.5};
    const Arc2 arc = arc_of(a, b, sagitta);
    CHECK(std::fabs(norm(a - arc.centre) - arc.radius) < 1e-12);
    std::vector<Vec2> chords;
    append_arc(chords, a, b, sagitta, 1e-3);
    chords.push_back(b);
    double apex = 0;
    for (size_t i = 0; i + 1 < chords.size(); ++i) {
      const Vec2 middle = (chords[i] + chords[i + 1]) * 0.5;
      CHECK(arc.radius - norm(middle - arc.centre) <= 1e-3);
      const Vec2 chord = b - a, from = middle - a;
      const double right = -(chord.u * from.v - chord.v * from.u) / norm(chord);
      apex = std::fabs(right) > std::fabs(apex) ? right : apex;
    }
    CHECK(apex == doctest::Approx(sagitta).epsilon(0.01).scale(0));
  }
}

TEST_CASE("topology: a straight edge gives its first corner only") {
  std::vector<Vec2> chords;
  append_arc(chords, {1, 2}, {3, 4}, 0, 1e-3);
  REQUIRE(chords.size() == 1);
  CHECK(chords[0] == Vec2{1, 2});
}
