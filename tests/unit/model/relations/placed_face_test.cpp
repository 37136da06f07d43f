// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "model/relations/placed_face.h"

#include <doctest/doctest.h>

#include "geometry/polygon2.h"
#include "unit/model/relations/boxes.h"

using namespace jalon;
using namespace jalon::test;

TEST_CASE("placed_face__comes_back_from_its_plane_and_keeps_its_holes_and_arcs") {
  Model m;
  add_flat(m, {upright(0, 0, 4, 3, 7), {{1, 7, 1}, {1, 7, 2}, {2, 7, 2}, {2, 7, 1}}});
  m.sagittas.assign(m.corners.size(), 0);
  m.sagittas[5] = -0.5;  // the head of the hole
  const PlacedFace face = placed_face(m, m.faces[0], 0.001);
  CHECK(face.plane.normal.y == doctest::Approx(-1));
  CHECK(signed_area(face.polygon.outline) == doctest::Approx(12));
  REQUIRE(face.polygon.holes.size() == 1);
  CHECK(std::fabs(signed_area(face.polygon.holes[0])) ==
        doctest::Approx(1 + 0.3927).epsilon(0.003).scale(0));
  for (const Vec3& p : corners_of(face)) CHECK(p.y == doctest::Approx(7));
  const PlacedFace filling = placed_filling(m, m.faces[0], m.rings[1], 0.001);
  CHECK(filling.box.max.z == doctest::Approx(2.5).epsilon(0.001));
  CHECK(are_coplanar(face, filling, 1e-9));
  CHECK(std::fabs(signed_area(seen_in(filling, face).outline)) ==
        doctest::Approx(1.3927).epsilon(0.003));
}

TEST_CASE("placed_face__boxes_apart_and_near") {
  const Box3 a{{0, 0, 0}, {1, 1, 1}}, b{{4, 5, 0}, {5, 6, 1}};
  CHECK(box_distance(a, b) == doctest::Approx(5));
  CHECK(box_distance(a, a) == 0);
  CHECK(are_near(a, b, 4.01));
  CHECK(!are_near(a, b, 3.99));
}
