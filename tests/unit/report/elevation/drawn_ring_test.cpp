// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// Arcs in random planes: the path, evaluated as SVG 1.1 F.6.5 says, against the arc in space.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

#include "base/random.h"
#include "report/elevation/drawn_ring.h"
#include "unit/report/drawn.h"
#include "unit/report/named_facade.h"

using namespace jalon;

namespace {

constexpr double kMillimetresAMetre = 1000;

// The point half way (in the ellipse's own angle) along "M x y A rx ry rotation large sweep x y", y down.
Vec2 middle_of_arc(const std::string& d) {
  std::string words = d.substr(1, d.find('Z') - 1);
  for (char& c : words)
    if (c == 'A') c = ' ';
  std::istringstream in(words);
  Vec2 a, b;
  double rx = 0, ry = 0, degrees = 0, large = 0, sweep = 0;
  in >> a.u >> a.v >> rx >> ry >> degrees >> large >> sweep >> b.u >> b.v;
  REQUIRE(!in.fail());
  const double phi = degrees * std::numbers::pi / 180, c = std::cos(phi), s = std::sin(phi);
  const Vec2 h = (a - b) * 0.5, p{c * h.u + s * h.v, -s * h.u + c * h.v};
  const double grow = std::max(1.0, std::hypot(p.u / rx, p.v / ry));
  rx *= grow, ry *= grow;
  const double q = rx * rx * p.v * p.v + ry * ry * p.u * p.u;
  double root = std::sqrt(std::max(0.0, (rx * rx * ry * ry - q) / q));
  if (large == sweep) root = -root;
  const Vec2 centre{root * rx * p.v / ry, -root * ry * p.u / rx};
  const double from = std::atan2((p.v - centre.v) / ry, (p.u - centre.u) / rx),
               to = std::atan2((-p.v - centre.v) / ry, (-p.u - centre.u) / rx);
  double turn = std::fmod(to - from, 2 * std::numbers::pi);
  if (sweep == 0 && turn > 0) turn -= 2 * std::numbers::pi;
  if (sweep != 0 && turn < 0) turn += 2 * std::numbers::pi;
  const Vec2 e{rx * std::cos(from + turn / 2) + centre.u,
               ry * std::sin(from + turn / 2) + centre.v};
  return Vec2{c * e.u - s * e.v, s * e.u + c * e.v} + (a + b) * 0.5;
}

}  // namespace

TEST_CASE("drawn_ring__arcs_in_any_plane_reach_the_page_where_they_are_in_space") {
  RandomStream random(1, 0);
  for (int trial = 0; trial < 300; ++trial) {
    CAPTURE(trial);
    const Vec3 normal = normalized({random.normal(), random.normal(), random.normal()});
    if (std::fabs(normal.y) < 0.3) continue;  // too flat an ellipse for the tolerance
    const Vec3 along = normalized(cross(normal, {0.3, 0.5, 0.8})),
               a{5 * random.uniform(), 5 * random.uniform(), 5 * random.uniform()},
               b = a + along * (0.3 + random.uniform());
    // From a flat arc to the larger part of a circle, to either side.
    const double chord = norm(b - a), sagitta = (random.uniform() < 0.5 ? 1 : -1) * chord *
                                                (0.1 + 1.2 * random.uniform());
    Model m;
    named_facade::add(m, 0, {normal, dot(normal, a)}, {{a, b}}, {sagitta, 0}, 1, 1);
    const DrawnRing ring = drawn_ring(m, m.faces[0], 0, ElevationView{});
    REQUIRE(ring.arcs.size() == 2);
    CHECK(ring.arcs[1].radius_m == 0);
    const double radius = (chord * chord / 4 + sagitta * sagitta) / (2 * std::fabs(sagitta));
    CHECK(ring.arcs[0].radius_m == doctest::Approx(radius));
    CHECK(ring.arcs[0].flat_m == doctest::Approx(radius * std::fabs(normal.y)));
    // A positive sagitta bulges to the right of the walk, seen against the normal.
    const Vec3 crown = (a + b) * 0.5 + cross(along, normal) * sagitta;
    const OnPaper on_paper{kMillimetresAMetre, {100, 9000}, {0, 0}};
    const Vec2 wanted = on_paper({crown.x, crown.z}), got = middle_of_arc(svg_path(ring, on_paper));
    // Rounding by 0.0005 mm moves the centre of half a circle (r < 0.7 m) by sqrt(2 r 0.0005) = 0.8 mm, the slant
    // by 1 / 0.3 of it; an arc to the wrong side or the wrong part of the circle is off by 18 mm and more.
    CHECK(norm(wanted - got) < 5);
  }
}

TEST_CASE("drawn_ring__chords_lie_on_the_arc_within_a_millimetre") {
  // A circle of 2 m about (3, 4) in the plane y = 0, as two halves.
  Model m;
  named_facade::add(m, 0, {{0, -1, 0}, 0}, {{{5, 0, 4}, {1, 0, 4}}}, {2, 2}, 12, 1);
  const DrawnRing ring = drawn_ring(m, m.faces[0], 0, ElevationView{});
  REQUIRE(ring.polygon.size() > 20);
  for (size_t i = 0; i < ring.polygon.size(); ++i) {
    const Vec2 p = ring.polygon[i], q = ring.polygon[(i + 1) % ring.polygon.size()];
    CHECK(norm(p - Vec2{3, 4}) == doctest::Approx(2));
    CHECK(norm((p + q) * 0.5 - Vec2{3, 4}) > 2 - 0.001 - 1e-12);
  }
  CHECK(ring.corners.size() == 2);
}

TEST_CASE("drawn_ring__straight_rings_are_their_corners_with_heights_up_the_page") {
  Model m;
  const std::vector<Vec3> corners{{1, 7, 2}, {4, 7, 2}, {4, 7, 3}, {2, 8, 5}};
  named_facade::add(m, 0, {{0, -1, 0}, -7}, {corners, {}}, {}, 4, 1);
  ElevationView view;
  view.T_view_world.m = {0, 1, 0, 10, -1, 0, 0, 0, 0, 0, 1, 0};  // x along world y
  const DrawnRing ring = drawn_ring(m, m.faces[0], 0, view);
  CHECK(ring.arcs.empty());
  CHECK(ring.polygon == ring.corners);
  REQUIRE(ring.corners.size() == 4);
  for (size_t i = 0; i < 4; ++i) CHECK(ring.corners[i] == Vec2{corners[i].y + 10, corners[i].z});
  const OnPaper on_paper{10, {20, 100}, {17, 2}};
  const auto page = drawn::corners(svg_path(ring, on_paper));
  CHECK(page == std::vector<Vec2>{{20, 100}, {20, 100}, {20, 90}, {30, 70}});
  // An empty ring is nothing; several make one path.
  const DrawnRing empty = drawn_ring(m, m.faces[0], 1, view);
  CHECK(svg_path(empty, on_paper).empty());
  CHECK(svg_path(std::vector<DrawnRing>{ring, empty, ring}, on_paper) ==
        svg_path(ring, on_paper) + svg_path(ring, on_paper));
}
