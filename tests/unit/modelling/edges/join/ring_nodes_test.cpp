// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Edges of a ring joined at their nodes.
#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "modelling/edges/join/ring_nodes.h"

using namespace jalon;

namespace {

constexpr double kRingNodesSpacing = 0.02, kReach = 0.2;

/// An edge on this line whose contour ends a little before its corners.
EdgeShape cut_short(const Vec2& from, const Vec2& to) {
  EdgeShape out = straight_shape(from, to);
  out.set_ends(out.at(0.05, 0.01), out.at(out.length_m - 0.05, 0.01));
  return out;
}

EdgeShape arc(const Vec2& centre, double radius, double turn, double from, double to) {
  EdgeShape out;
  out.is_arc = true;
  out.circle = {centre, radius};
  out.turn = turn;
  const auto at = [&](double a) { return centre + Vec2{std::cos(a), std::sin(a)} * radius; };
  out.set_ends(at(from), at(to));
  return out;
}

}  // namespace

TEST_CASE("ring_nodes__lie_where_lines_meet_and_edges_keep_what_is_known_of_them") {
  std::vector<EdgeShape> edges{cut_short({0, 0}, {4, 0}), cut_short({4, 0}, {4, 3}),
                               cut_short({4, 3}, {0.5, 3}), cut_short({0.5, 3}, {0, 0})};
  for (size_t e = 0; e < 4; ++e) edges[e].sigma_m = 0.001 * static_cast<double>(e + 1);
  edges[1].source = EdgeSource::kReveal;
  const auto ring = join_edges(edges, kRingNodesSpacing, kReach);
  REQUIRE(ring);
  const Vec2 truth[] = {{0, 0}, {4, 0}, {4, 3}, {0.5, 3}};
  REQUIRE(ring->corners.size() == 4);
  for (size_t i = 0; i < 4; ++i) {
    CHECK(norm(ring->corners[i] - truth[i]) < 1e-12);
    CHECK(ring->edges[i].sigma_m == edges[i].sigma_m);
    CHECK(ring->edges[i].direction == edges[i].direction);
    CHECK(ring->edges[i].source == edges[i].source);
    CHECK(ring->edges[i].sagitta_m == 0);
  }
  CHECK(ring->corners[1] == Vec2{4, 0});  // upright lines: to the last bit
}

TEST_CASE("ring_nodes__a_line_that_passes_its_arc_by_little_touches_it") {
  // A round-headed wall whose arc is 5 mm smaller than the distance of the jambs.
  const double r = 0.995;
  const std::vector<EdgeShape> edges{cut_short({0, 0}, {2, 0}), cut_short({2, 0}, {2, 3}),
                                     arc({1, 3}, r, 1, 0.03, std::numbers::pi - 0.03),
                                     cut_short({0, 3}, {0, 0})};
  const auto ring = join_edges(edges, kRingNodesSpacing, kReach);
  REQUIRE(ring);
  REQUIRE(ring->corners.size() == 4);
  CHECK(norm(ring->corners[2] - Vec2{2, 3}) < 1e-9);
  CHECK(norm(ring->corners[3] - Vec2{0, 3}) < 1e-9);
  CHECK(ring->edges[2].sagitta_m == doctest::Approx(r).epsilon(0.01).scale(0));
  CHECK(signed_area(*ring) == doctest::Approx(6 + std::numbers::pi / 2).epsilon(0.01).scale(0));
}

TEST_CASE("ring_nodes__two_edges_make_a_ring_with_their_arcs_halved") {
  const double pi = std::numbers::pi;
  const std::vector<EdgeShape> half{straight_shape({-1, 0}, {1, 0}), arc({0, 0}, 1, 1, 0, pi)};
  const auto lens = join_edges(half, kRingNodesSpacing, kReach);
  REQUIRE(lens);
  CHECK(lens->corners.size() == 3);
  CHECK(signed_area(*lens) == doctest::Approx(pi / 2));
  const std::vector<EdgeShape> circle{arc({0, 0}, 1, -1, pi, 0), arc({0, 0}, 1, -1, 0, -pi)};
  const auto opening = join_edges(circle, kRingNodesSpacing, kReach);
  REQUIRE(opening);
  CHECK(opening->corners.size() == 4);
  CHECK(signed_area(*opening) == doctest::Approx(-pi));
}

TEST_CASE("ring_nodes__neighbours_that_do_not_meet_near_their_ends_have_a_short_edge_across") {
  const std::vector<EdgeShape> edges{
      straight_shape({0, 0}, {2, 0}), straight_shape({2, 0.3}, {4, 0.3}),
      straight_shape({4, 0.3}, {4, 3}), straight_shape({4, 3}, {0, 3}),
      straight_shape({0, 3}, {0, 0})};
  const auto ring = join_edges(edges, kRingNodesSpacing, kReach);
  REQUIRE(ring);
  REQUIRE(ring->corners.size() == 6);
  CHECK(ring->corners[1] == Vec2{2, 0});
  CHECK(ring->corners[2] == Vec2{2, 0.3});
  CHECK(std::isnan(ring->edges[1].sigma_m));
  // Lines that meet half a metre from where the contours part.
  const std::vector<EdgeShape> chamfered{
      straight_shape({0, 0}, {3.5, 0}), straight_shape({4, 0.5}, {4, 3}),
      straight_shape({4, 3}, {0, 3}), straight_shape({0, 3}, {0, 0})};
  CHECK(join_edges(chamfered, kRingNodesSpacing, kReach)->corners.size() == 5);
  CHECK(join_edges(chamfered, kRingNodesSpacing, 0.6)->corners.size() == 4);
}

TEST_CASE("ring_nodes__no_ring_of_one_edge_of_backward_ones_or_that_crosses_itself") {
  CHECK(!join_edges({}, kRingNodesSpacing, kReach));
  const std::vector<EdgeShape> one{arc({0, 0}, 1, 1, 0, 6.2)};
  CHECK(!join_edges(one, kRingNodesSpacing, kReach));
  // The short edge at the right would run down between its neighbours' nodes.
  const std::vector<EdgeShape> backward{
      straight_shape({0, 0}, {4, 0.4}), straight_shape({4, 0.35}, {4, 0.38}),
      straight_shape({4, 0.33}, {0, 3}), straight_shape({0, 3}, {0, 0})};
  CHECK(!join_edges(backward, kRingNodesSpacing, kReach));
  const std::vector<EdgeShape> bow{straight_shape({0, 0}, {4, 4}), straight_shape({4, 4}, {4, 0}),
                                   straight_shape({4, 0}, {0, 4}), straight_shape({0, 4}, {0, 0})};
  CHECK(!join_edges(bow, kRingNodesSpacing, kReach));
}
