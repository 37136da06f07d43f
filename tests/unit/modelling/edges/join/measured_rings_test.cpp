// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Rings of one plane from its contour and the points near it.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "base/random.h"
#include "modelling/edges/join/measured_rings.h"

using namespace jalon;

namespace {

constexpr double kSpacing = 0.02;

/// Points at random places of a wall 3 x 2 m with a window.
std::vector<Vec2> wall_with_window() {
  RandomStream random(11, 61);
  std::vector<Vec2> out;
  for (double u = 0; u < 3; u += kSpacing)
    for (double v = 0; v < 2; v += kSpacing) {
      const Vec2 p{u + kSpacing * random.uniform(), v + kSpacing * random.uniform()};
      if (p.u > 3 || p.v > 2 || (p.u > 1 && p.u < 1.8 && p.v > 0.7 && p.v < 1.5)) continue;
      out.push_back(p);
    }
  return out;
}

NearPoints all_near(const std::vector<Vec2>& points) {
  NearPoints out;
  out.points = points;
  out.heights_m.assign(points.size(), 0.0f);
  out.on_plane.assign(points.size(), 1);
  Task task;
  out.sort(0.1, task);
  return out;
}

double distance_to_nearest(const std::vector<Vec2>& places, const Vec2& p) {
  double best = INFINITY;
  for (const Vec2& q : places) best = std::min(best, norm(p - q));
  return best;
}

const std::vector<Vec2> kWall{{0, 0}, {3, 0}, {3, 2}, {0, 2}};
const std::vector<Vec2> kWindow{{1, 0.7}, {1.8, 0.7}, {1.8, 1.5}, {1, 1.5}};

}  // namespace

TEST_CASE("measured_rings__one_a_chain_with_corners_where_the_points_end") {
  Task task;
  const auto points = wall_with_window();
  const Contour contour = extract_contour(points, {}, task);
  REQUIRE(contour.pieces.size() == 1);
  REQUIRE(contour.pieces[0].openings.size() == 1);
  size_t asked = 0;
  const RingSource source{contour, 0.002,
                          [&](std::span<const std::vector<Vec2>> rings, const NearSetting& about) {
                            CHECK(rings.size() == 2);
                            CHECK(about.reach_m >= 9 * contour.spacing_m);
                            ++asked;
                            return all_near(points);
                          },
                          [] { return std::vector<EdgeLine>{}; }};
  const auto rings = measured_rings(source, {}, task);
  REQUIRE(rings.size() == 2);
  CHECK(asked == 1);
  CHECK(signed_area(rings[0]) == doctest::Approx(6).epsilon(0.01));
  CHECK(signed_area(rings[1]) == doctest::Approx(-0.64).epsilon(0.02).scale(0));
  for (size_t k = 0; k < 2; ++k) {
    CHECK(rings[k].corners.size() == 4);
    for (const Vec2& p : rings[k].corners)
      CHECK(distance_to_nearest(k == 0 ? kWall : kWindow, p) < 0.4 * kSpacing);
    for (const VectorEdge& edge : rings[k].edges) {
      CHECK(edge.source == EdgeSource::kDensity);
      CHECK(edge.sigma_m > 0);
      CHECK(edge.sigma_m < 0.4 * kSpacing);
      CHECK(edge.direction != EdgeDirection::kInclined);
    }
  }
  CHECK(rings[0].contour == contour.pieces[0].outline);
  CHECK(rings[1].contour == contour.pieces[0].openings[0]);
}

TEST_CASE("measured_rings__without_points_near_the_edges_are_those_of_the_contour") {
  Task task;
  const Contour contour = extract_contour(wall_with_window(), {}, task);
  const RingSource source{
      contour, 0.002,
      [](std::span<const std::vector<Vec2>>, const NearSetting&) { return NearPoints{}; },
      [] { return std::vector<EdgeLine>{}; }};
  const auto rings = measured_rings(source, {}, task);
  REQUIRE(rings.size() == 2);
  for (const VectorRing& ring : rings) {
    REQUIRE(ring.corners.size() == 4);
    for (const VectorEdge& edge : ring.edges) CHECK(edge.source == EdgeSource::kContour);
  }
  for (const Vec2& p : rings[0].corners) CHECK(distance_to_nearest(kWall, p) < kSpacing);
}

TEST_CASE("measured_rings__of_an_empty_contour_are_none") {
  Task task;
  Contour contour;
  contour.spacing_m = kSpacing;
  contour.max_edge_m = 4 * kSpacing;
  const RingSource source{
      contour, 0.002,
      [](std::span<const std::vector<Vec2>>, const NearSetting&) { return NearPoints{}; },
      [] { return std::vector<EdgeLine>{}; }};
  CHECK(measured_rings(source, {}, task).empty());
}
