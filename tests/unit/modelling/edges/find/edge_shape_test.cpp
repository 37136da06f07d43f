// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// An edge's own coordinates, and edges made of parts of a contour.
#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "base/random.h"
#include "modelling/edges/find/chain_parts.h"
#include "modelling/edges/find/edge_shape.h"

using namespace jalon;

namespace {

EdgeShape arc_shape(double turn) {
  EdgeShape out;
  out.is_arc = true;
  out.circle = {{1, 2}, 0.5};
  out.turn = turn;
  const Vec2 right{1.5, 2}, left{0.5, 2};
  if (turn > 0) out.set_ends(right, left);  // over the top, either way
  else out.set_ends(left, right);
  return out;
}

}  // namespace

TEST_CASE("edge_shape__places_on_it_have_their_own_coordinates_back") {
  RandomStream random(1, 1);
  for (const EdgeShape& shape : {straight_shape({1, 1}, {1, 4}), straight_shape({3, 1}, {-1, 2}),
                                 arc_shape(1), arc_shape(-1)}) {
    CHECK(norm(shape.at(0, 0) - shape.first) < 1e-12);
    CHECK(norm(shape.at(shape.length_m, 0) - shape.last) < 1e-12);
    for (int k = 0; k < 50; ++k) {
      const double t = shape.length_m * random.uniform(), d = 0.4 * (2 * random.uniform() - 1);
      const Vec2 back = shape.local(shape.at(t, d));
      CHECK(back.u == doctest::Approx(t));
      CHECK(back.v == doctest::Approx(d));
    }
  }
}

TEST_CASE("edge_shape__the_solid_is_on_the_left_of_lines_and_inside_anticlockwise_arcs") {
  CHECK(straight_shape({0, 0}, {1, 0}).local({0.5, 0.2}).v == 0.2);
  const EdgeShape post = arc_shape(1), opening = arc_shape(-1);
  CHECK(post.length_m == doctest::Approx(std::numbers::pi / 2));
  CHECK(opening.length_m == doctest::Approx(std::numbers::pi / 2));
  CHECK(post.local({1, 2.4}).v == doctest::Approx(0.1));
  CHECK(opening.local({1, 2.4}).v == doctest::Approx(-0.1));
  // Shorter inside, longer outside: the share of a ring's circumference.
  CHECK(post.widening(0.1) == doctest::Approx(0.4 / 0.5));
  CHECK(opening.widening(0.1) == doctest::Approx(0.6 / 0.5));
  CHECK(straight_shape({0, 0}, {1, 0}).widening(0.3) == 1);
}

TEST_CASE("edge_shape__shifted_into_the_solid_its_places_move_by_so_much") {
  for (EdgeShape shape : {straight_shape({3, 1}, {-1, 2}), arc_shape(1), arc_shape(-1)}) {
    const Vec2 before = shape.at(shape.length_m / 2, 0);
    shape.shift(0.03);
    CHECK(shape.local(before).v == doctest::Approx(-0.03));
  }
}

TEST_CASE("edge_shape__a_line_snaps_where_its_ends_move_by_little_and_only_then") {
  const auto tilted = [](double length_m, double angle) {
    return straight_shape({1, 1},
                          Vec2{1 + length_m * std::sin(angle), 1 + length_m * std::cos(angle)});
  };
  EdgeShape shape = tilted(1, 0.01);  // its ends move by 5 mm
  CHECK(shape.direction == EdgeDirection::kInclined);
  CHECK(shape.upright_angle() == doctest::Approx(0.01));
  const Vec2 middle = (shape.first + shape.last) * 0.5;
  CHECK(shape.snap(0.05, 0, 0.01));
  CHECK(shape.line.direction == Vec2{0, 1});
  CHECK(shape.direction == EdgeDirection::kVertical);
  CHECK(std::fabs(shape.line.distance(middle)) < 1e-12);
  EdgeShape wide = tilted(4, 0.01);  // by 2 cm, more than the spacing
  CHECK(!wide.snap(0.05, 0, 0.01));
  CHECK(wide.snap(0.05, 0.02, 0.01));  // which noise explains
  EdgeShape never = tilted(1, 0.01);
  CHECK(!never.snap(0, 0, 0.01));
  EdgeShape arc = arc_shape(1);
  CHECK(!arc.snap(0.05, 0.05, 1));
}

TEST_CASE("edge_shape__of_a_part_lies_outside_its_contour_by_the_mean_set_back") {
  std::vector<Vec2> chain;
  for (int i = 0; i <= 100; ++i) chain.push_back({0.01 * i, 2});
  chain.push_back({0.5, 3});
  ChainPart part;
  part.count = 101;
  part.line = {{0.4, 2}, {1, 0}};
  const EdgeShape shape = shape_of(chain, part, 0.01, 0.035, 0.05);
  CHECK(shape.line.distance({0, 2}) == doctest::Approx(kSetBack * 0.01));
  CHECK(shape.direction == EdgeDirection::kHorizontal);
  CHECK(shape.length_m == doctest::Approx(1));
  CHECK(std::isnan(shape.sigma_m));
  CHECK(shape.source == EdgeSource::kContour);
  CHECK(straight_shape({0, 0}, {0, -2}).line.direction == Vec2{0, -1});
  CHECK(straight_shape({5, 1}, {2, 1}).direction == EdgeDirection::kHorizontal);
}
