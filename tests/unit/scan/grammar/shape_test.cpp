// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include "geometry/polygon2.h"
#include "model/topology.h"
#include "scan/grammar/shape.h"

using namespace jalon;
using namespace jalon::grammar;

namespace {

double distance_from(const Outline& ring, const Vec2& p) {
  double best = 1e9;
  for (size_t k = 0; k < ring.size(); ++k) {
    const Vec2 a = ring[k], d = ring[(k + 1) % ring.size()] - a;
    best = std::min(best, norm(p - a - d * std::clamp(dot(p - a, d) / dot(d, d), 0.0, 1.0)));
  }
  return best;
}

std::vector<Shape> forms() {
  return {Shape::flat({1, 2, 3, 5}),        Shape::arched({1, 2, 3, 5}, 0.2),
          Shape::arched({1, 2, 3, 5}, 0.5), Shape::pointed({1, 2, 3, 5}),
          Shape::round({1.5, 4}, 0.5),      Shape::polygon({{1, 3}, {2, 3}, {2, 5}})};
}

}  // namespace

TEST_CASE("shape__contours_run_counter_clockwise_and_fill_their_rectangle") {
  for (const Shape& shape : forms()) {
    const Contour contour = contour_of(shape);
    CHECK(area_of(contour) > 0);
    const Rect box = bounds_of(contour);
    CHECK(box.u0 == doctest::Approx(1).epsilon(1e-3));
    CHECK(box.u1 == doctest::Approx(2).epsilon(1e-3));
    CHECK(box.v1 == doctest::Approx(shape.form == Shape::Form::kRound ? 4.5 : 5).epsilon(1e-3));
  }
}

TEST_CASE("shape__a_pointed_arch_has_its_width_as_radius") {
  const Contour arch = contour_of(Shape::pointed({0, 2, 0, 4}));
  const Arc2 right = arc_of(arch[2].at, arch[3].at, arch[2].sagitta_m),
             left = arc_of(arch[3].at, arch[4].at, arch[3].sagitta_m);
  CHECK(right.radius == doctest::Approx(2));
  CHECK(left.radius == doctest::Approx(2));
  CHECK(norm(right.centre - arch[4].at) < 1e-9);
  CHECK(norm(left.centre - arch[2].at) < 1e-9);
}

TEST_CASE("shape__grows_and_shrinks_by_the_same_width_all_round") {
  for (const Shape& shape : forms()) {
    if (shape.form == Shape::Form::kPointed) continue;  // its tip is made anew
    const Outline own = chords_of(contour_of(shape));
    for (const double by : {0.1, -0.1}) {
      CAPTURE(static_cast<int>(shape.form));
      const Contour other = contour_of(grown(shape, by, false));
      CHECK((area_of(other) > area_of(contour_of(shape))) == (by > 0));
      for (size_t k = 0; k < other.size(); ++k) {  // the middles of edges; corners are farther
        const Vec2 a = other[k].at, b = other[(k + 1) % other.size()].at;
        const Vec2 along = b - a, right = Vec2{along.v, -along.u} * (1 / norm(along));
        const Vec2 middle = (a + b) * 0.5 + right * other[k].sagitta_m;
        CHECK(distance_from(own, middle) == doctest::Approx(0.1).epsilon(2e-3).scale(0));
      }
    }
  }
  // A door's surround stands on the ground as the door does.
  CHECK(bounds_of(contour_of(grown(Shape::flat({1, 2, 0, 2}), 0.1, true))).v0 == 0);
}

TEST_CASE("shape__shrinks_only_where_something_is_left") {
  CHECK(can_shrink(Shape::flat({0, 0.31, 0, 2}), 0.1));
  CHECK_FALSE(can_shrink(Shape::flat({0, 0.29, 0, 2}), 0.1));
  CHECK_FALSE(can_shrink(Shape::polygon({{0, 0}, {0.5, 0}, {0, 0.5}}), 0.1));
  CHECK(springing_of(Shape::arched({0, 1, 0, 2}, 0.3)) == doctest::Approx(1.7));
  CHECK(springing_of(Shape::flat({0, 1, 0, 2})) == 2);
}
