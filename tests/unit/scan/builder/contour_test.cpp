// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <numbers>

#include "geometry/polygon2.h"
#include "scan/builder/contour.h"
#include "unit/scan/scenes/built.h"

using namespace jalon;
using namespace jalon::test;

namespace {

const Contour kHalfDisc{{{-1, 0}}, {{1, 0}, 1}};  // a chord, and a semicircle over it
const Frame kContourFront{{}, {1, 0, 0}, {0, 0, 1}};

}  // namespace

TEST_CASE("contour__chords_stay_within_a_tenth_of_a_millimetre_of_arcs") {
  const Outline ring = chords_of(kHalfDisc);
  CHECK(ring.size() > 40);
  for (size_t k = 1; k + 1 < ring.size(); ++k) {
    CHECK(norm(ring[k]) == doctest::Approx(1));
    CHECK(norm((ring[k] + ring[k + 1]) * 0.5) > 1 - 1e-4);
  }
  // To the left of the walk the other way: a flat arc of 0.2 m over 2 m has a radius of 2.6 m.
  const Outline left = chords_of({{{1, 0}, -0.2}, {{-1, 0}}});
  CHECK(left.size() > 10);
  for (const Vec2& p : left) CHECK(norm(p - Vec2{0, 2.4}) == doctest::Approx(2.6));
  CHECK(area_of(kHalfDisc) == doctest::Approx(std::numbers::pi / 2).epsilon(2e-4));
  CHECK(bounds_of(kHalfDisc).v1 == doctest::Approx(1).epsilon(1e-4));
  CHECK(area_of(contour_of(Rect{1, 3, 2, 5})) == doctest::Approx(6));
}

TEST_CASE("contour__notched_walks_round_openings_that_stand_on_the_outline") {
  const Contour wall = contour_of(Rect{0, 10, 0, 5});
  Contour door = contour_of(Rect{2, 3, 0, 2}), arch = contour_of(Rect{5, 7, 0, 2});
  arch[2].sagitta_m = 1;
  const Contour window = contour_of(Rect{8, 9, 1, 2});
  CHECK(touches_border(wall, door));
  CHECK(touches_border(wall, arch));
  CHECK_FALSE(touches_border(wall, window));
  const Contour both = notched(wall, {arch, door});
  CHECK(both.size() == wall.size() + 8);
  CHECK(area_of(both) == doctest::Approx(50 - area_of(door) - area_of(arch)));
  const Outline ring = chords_of(both);
  CHECK_FALSE(contains(ring, {2.5, 1}));
  CHECK_FALSE(contains(ring, {6, 2.9}));
  CHECK(contains(ring, {6, 3.1}));
  CHECK(area_of(notched(wall, {window})) == doctest::Approx(50));
}

TEST_CASE("contour__sides_close_a_prism_seen_from_outside_or_a_pocket_seen_from_inside") {
  for (const bool from_inside : {false, true}) {
    CAPTURE(from_inside);
    SceneBuilder out{Transform{}};
    const uint32_t part = out.part("sides", "reveal");
    add_sides(out, part, kContourFront, kHalfDisc, -0.5, 0.25, from_inside);
    const Outline ring = chords_of(kHalfDisc);
    out.polygon_face(part, kContourFront.raised(from_inside ? -0.5 : 0.25), ring);
    const Model model = out.take();
    // The contour's area open at one end: at y = 0.5 of the prism, at the front of the pocket.
    const Shell shell = shell_of(model, {}, {0, from_inside ? -0.25 : 0.5, 0});
    const double area_m2 = signed_area(ring);
    CHECK(norm(shell.vector_area - Vec3{0, -area_m2, 0}) < kRounding_m);
    CHECK(shell.volume_m3 == doctest::Approx((from_inside ? -0.75 : 0.75) * area_m2));
    for (const Face& face : model.faces) CHECK(is_sound(model, face));
  }
}
