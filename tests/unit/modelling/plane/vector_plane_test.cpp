// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Areas and points of rings with arcs.
#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "geometry/polygon2.h"
#include "unit/modelling/plane_rings.h"

using namespace rings;

TEST_CASE("vector_plane__areas_count_what_lies_between_arcs_and_chords") {
  VectorRing ring = rectangle({0, 0}, {2, 3});
  CHECK(signed_area(ring) == 6);
  ring.edges[2].sagitta_m = 1;  // half a disc of radius 1 outside
  CHECK(signed_area(ring) == doctest::Approx(6 + std::numbers::pi / 2));
  ring.edges[2].sagitta_m = -1;  // and inside
  CHECK(signed_area(ring) == doctest::Approx(6 - std::numbers::pi / 2));
  // A disc as two halves, anticlockwise.
  VectorRing disc = ring_of({{-5, 0}, {5, 0}});
  disc.edges[0].sagitta_m = disc.edges[1].sagitta_m = 5;
  CHECK(signed_area(disc) == doctest::Approx(25 * std::numbers::pi));
}

TEST_CASE("vector_plane__openings_are_taken_off_a_face") {
  const VectorFace face{rectangle({0, 0}, {10, 5}), {hole({1, 1}, {2, 3}), hole({4, 1}, {5, 2})}};
  CHECK(area(face) == doctest::Approx(50 - 2 - 1));
}

TEST_CASE("vector_plane__flattened_points_lie_on_the_arc_and_their_chords_near_it") {
  VectorRing ring = rectangle({0, 0}, {2, 3});
  CHECK(flattened(ring, 0.01) == ring.corners);
  ring.edges[2].sagitta_m = 1;
  size_t last = 0;
  for (const double error_m : {0.1, 0.01, 0.001}) {
    const auto points = flattened(ring, error_m);
    CHECK(points.size() > last);
    last = points.size();
    for (size_t i = 0; i < points.size(); ++i) {
      const Vec2 a = points[i], b = points[(i + 1) % points.size()];
      if (std::min(a.v, b.v) < 3 - 1e-9) continue;
      CHECK(norm(a - Vec2{1, 3}) == doctest::Approx(1));
      CHECK(norm((a + b) * 0.5 - Vec2{1, 3}) >= 1 - error_m - 1e-12);
    }
    CHECK(signed_area(points) == doctest::Approx(6 + std::numbers::pi / 2).epsilon(error_m));
  }
}
