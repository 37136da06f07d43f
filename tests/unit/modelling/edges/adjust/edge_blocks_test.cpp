// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// The points beside an edge, in blocks.
#include <doctest/doctest.h>

#include <cmath>

#include "base/random.h"
#include "modelling/edges/adjust/edge_blocks.h"

using namespace jalon;

namespace {

constexpr double kEdgeBlocksSpacing = 0.01;

/// Points about an edge from (0, 0) to (1, 0): on the plane, behind and before it.
NearPoints about_edge() {
  NearPoints out;
  RandomStream random(5, 5);
  for (int i = 0; i < 3000; ++i) {
    out.points.push_back({1.4 * random.uniform() - 0.2, 0.3 * random.uniform() - 0.1});
    const int kind = i % 5;
    out.on_plane.push_back(kind < 3 ? 1 : 0);
    out.heights_m.push_back(kind < 3 ? 0.001f : kind == 3 ? -0.1f : 0.05f);
  }
  Task task;
  out.sort(0.1, task);
  return out;
}

MeasuredEdge measured(const EdgeShape& shape) {
  MeasuredEdge out;
  out.shape = shape;
  return out;
}

}  // namespace

TEST_CASE("edge_blocks__tile_the_edge_less_its_ends_and_take_each_point_of_the_strip_once") {
  const NearPoints near = about_edge();
  MeasuredEdge edge = measured(straight_shape({0, 0}, {1, 0}));
  edge.behind.push_back({});  // of another pass
  collect_blocks(near, {}, kEdgeBlocksSpacing, 0.03, edge);
  REQUIRE(edge.blocks.size() == 12);  // of eight spacings and a little
  double at = kEdgeBlocksSpacing;
  size_t taken = 0;
  for (const EdgeBlock& block : edge.blocks) {
    CHECK(block.t_m - block.length_m / 2 == doctest::Approx(at));
    at += block.length_m;
    CHECK(block.depth_m == doctest::Approx(kStripInward * kEdgeBlocksSpacing));
    CHECK(block.outward_m == doctest::Approx(kStripOutward * kEdgeBlocksSpacing));
    for (size_t i = 0; i < block.points.size(); ++i) {
      CHECK(block.points[i].weight == 1);
      if (i > 0) CHECK(block.points[i - 1].d_m <= block.points[i].d_m);
    }
    taken += block.points.size();
  }
  CHECK(at == doctest::Approx(1 - kEdgeBlocksSpacing));
  size_t expected = 0, behind = 0, before = 0;
  for (size_t i = 0; i < near.points.size(); ++i) {
    const Vec2& p = near.points[i];
    if (p.u < kEdgeBlocksSpacing || p.u > 1 - kEdgeBlocksSpacing) continue;
    expected += near.on_plane[i] != 0 && p.v >= -kStripOutward * kEdgeBlocksSpacing &&
                p.v <= kStripInward * kEdgeBlocksSpacing;
    behind += near.heights_m[i] < -0.03f && std::fabs(p.v) <= 2 * kEdgeBlocksSpacing;
    before += near.heights_m[i] > 0.03f && std::fabs(p.v) <= 2 * kEdgeBlocksSpacing;
  }
  CHECK(taken == expected);
  CHECK(edge.behind.size() == behind);
  CHECK(edge.before.size() == before);
  CHECK(behind > 10);
  collect_blocks(near, {}, kEdgeBlocksSpacing, 0.07, edge);  // higher off the plane
  CHECK(edge.behind.size() == behind);
  CHECK(edge.before.empty());
}

TEST_CASE("edge_blocks__end_before_the_contours_of_other_edges_but_not_at_their_own") {
  const std::vector<std::vector<Vec2>> rings{
      {{0.5, 0.05}, {0.51, 0.05}, {0.2, -0.02}, {0.8, 0.012}, {0.9, -0.1}}};
  Task task;
  const PointRows contours = contour_points(rings, kEdgeBlocksSpacing, task);
  CHECK(contours.points.size() == 5);
  MeasuredEdge edge = measured(straight_shape({0, 0}, {1, 0}));
  collect_blocks({}, contours, kEdgeBlocksSpacing, 0.03, edge);
  for (const EdgeBlock& block : edge.blocks) {
    const auto holds = [&](double t) { return std::fabs(t - block.t_m) < block.length_m / 2; };
    CHECK(block.depth_m == doctest::Approx(holds(0.5) || holds(0.51) ? 0.04 : 0.09));
    CHECK(block.outward_m == doctest::Approx(holds(0.2) ? 0.015 : 0.025));
  }
}

TEST_CASE("edge_blocks__a_short_edge_has_none_and_points_of_an_arc_weigh_against_its_widening") {
  MeasuredEdge edge = measured(straight_shape({0, 0}, {0.029, 0}));
  const NearPoints near = about_edge();
  collect_blocks(near, {}, kEdgeBlocksSpacing, 0.03, edge);
  CHECK(edge.blocks.empty());
  EdgeShape arc;
  arc.is_arc = true;
  arc.circle = {{0.5, 0.2}, 0.2};
  arc.turn = 1;
  arc.set_ends({0.3, 0.2}, {0.7, 0.2});  // round below
  edge.shape = arc;
  collect_blocks(near, {}, kEdgeBlocksSpacing, 0.03, edge);
  REQUIRE(!edge.blocks.empty());
  size_t points = 0;
  for (const EdgeBlock& block : edge.blocks)
    for (const StripPoint& p : block.points) {
      ++points;
      CHECK(p.weight == doctest::Approx(0.2 / (0.2 - p.d_m)));
    }
  CHECK(points > 50);
}
