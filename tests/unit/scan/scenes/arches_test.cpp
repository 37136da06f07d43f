// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "unit/scan/scenes/built.h"

using namespace jalon;
using namespace jalon::test;

// Both scenes of arched windows: how their walls join, and what rays meet in and beside the round heads.

namespace {

struct WallEnds {
  Vec3 left, right;
};

/// Feet of the two upright edges of a wall, seen from its front.
WallEnds ends_of(const Model& model, const Face& wall) {
  const Vec3 along = cross(Vec3{0, 0, 1}, wall.plane.normal);
  std::vector<Vec3> feet;
  const Ring& ring = model.rings[wall.first_ring];
  for (uint64_t k = ring.first; k < ring.first + ring.count; ++k) {
    const Vec3& p = model.vertices[model.corners[k]];
    if (p.z == 0) feet.push_back(p);
  }
  REQUIRE(feet.size() == 2);
  if (dot(feet[0] - feet[1], along) > 0) std::swap(feet[0], feet[1]);
  return {feet[0], feet[1]};
}

}  // namespace

TEST_CASE("scene_lycee__each_wall_begins_where_the_one_before_ends") {
  const Model model = built(build_lycee);
  const double widths[] = {14, 8, 10, 20, 6, 12};
  std::vector<WallEnds> walls;
  for (const Face& face : model.faces)
    if (model.parts[face.part].part_class == "wall") walls.push_back(ends_of(model, face));
  REQUIRE(walls.size() == 6);
  for (size_t i = 0; i < 6; ++i) {
    CHECK(std::abs(norm(walls[i].right - walls[i].left) - widths[i]) < kRounding_m);
    if (i > 0) CHECK(norm(walls[i].left - walls[i - 1].right) < kRounding_m);
  }
}

TEST_CASE("scene_lycee__each_window_has_a_stone_sill_below_it") {
  const Model model = built(build_lycee);
  const std::vector<uint32_t> sills = parts_named(model, "sill");
  REQUIRE(sills.size() == 8);
  for (size_t w = 0; w < 8; ++w) {
    // 1.4 x 0.1 x 0.12 m, closed by the wall y = 0 behind it; all its faces look outward.
    const Shell stone = shell_of(model, ids_of(model, "sill", sills[w]));
    CHECK(std::abs(stone.volume_m3 - 1.4 * 0.1 * 0.12) < kRounding_m);
    CHECK(norm(stone.vector_area + Vec3{0, 1.4 * 0.1, 0}) < kRounding_m);
    // Four bays of 3.5 m, openings of 1.2 m from 5 m and from 10 m up.
    const double x = 1.75 + 3.5 * static_cast<double>(w % 4), foot = w < 4 ? 5 : 10;
    for (const double aside : {-0.69, 0.0, 0.69}) {
      const Hit hit = first_hit(model, {x + aside, -0.06, foot + 0.5}, {0, 0, -1});
      CHECK(hit.distance == doctest::Approx(0.5));
      CHECK(class_of(model, hit.triangle) == "sill");
    }
  }
}

TEST_CASE("scene_lycee__its_seed_moves_the_leaves_of_two_crowns_and_nothing_else") {
  const Model one = built(build_lycee, {.seed = 1}), other = built(build_lycee, {.seed = 2});
  REQUIRE(one.vertices.size() == other.vertices.size());
  REQUIRE(one.triangle_faces == other.triangle_faces);
  const auto planar = faces_by_id(one);
  size_t leaves = 0;
  for (size_t t = 0; t < one.triangles.size(); ++t) {
    const auto here = corners_of(one, t), there = corners_of(other, t);
    if (here == there) continue;
    ++leaves;
    REQUIRE(!planar.contains(one.triangle_faces[t]));
    // Balls of 2 m about both middles, 4 m before the wall; leaves end 0.12 m outside of them.
    const double first = norm(here[0] - Vec3{3.06, -4, 8.7}),
                 second = norm(here[0] - Vec3{9.63, -4, 8.7});
    REQUIRE(std::min(first, second) <= 2.12 + kRounding_m);
  }
  CHECK(leaves > 2000);
}

TEST_CASE("scene_arches__panes_lie_15_cm_deep_and_walls_fill_the_corners_beside_round_heads") {
  const Model model = built(build_arches);
  struct Opening {
    double u, v, wall_y;
    bool is_arched;
  };
  const Opening openings[] = {{1.5, 1.2, 0, false},    {4.9, 1.2, 0, false},  {1.5, 4.8, 0, false},
                              {4.9, 4.8, 0, false},    {1.7, 8.4, 0, true},   {5.1, 8.4, 0, true},
                              {10.3, 1.2, 0.4, false}, {10.5, 4.8, 0.4, true}};
  for (const Opening& o : openings) {
    CAPTURE(o.u);
    CAPTURE(o.v);
    const double width = o.is_arched ? 1.2 : 1.6, height = o.is_arched ? 2.2 : 1.6;
    const double pane = o.wall_y + 0.15;
    CHECK(front_y(model, o.u + 0.01, o.v + 0.01) == doctest::Approx(pane));
    CHECK(front_y(model, o.u + width / 2, o.v + height - 0.01) == doctest::Approx(pane));
    CHECK(front_y(model, o.u + width / 2, o.v + height + 0.01) == doctest::Approx(o.wall_y));
    // The upper corners; a semicircle of 0.6 m passes 0.25 m from them.
    for (const double u : {o.u + 0.15, o.u + width - 0.15})
      CHECK(front_y(model, u, o.v + height - 0.15) ==
            doctest::Approx(o.is_arched ? o.wall_y : pane));
    CHECK(front_y(model, o.u + 0.2, o.v + height - 0.2) == doctest::Approx(pane));
  }
  // Sills, jambs and heads cancel: what is left are the walls of 8 x 12 m and 4.2 x 8 m, filled.
  CHECK(norm(shell_of(model, {}).vector_area + Vec3{0, 96 + 33.6, 0}) < kRounding_m);
  for (const uint32_t part : parts_named(model, "pane"))
    CHECK(shell_of(model, ids_of(model, "pane", part)).triangles > 0);
}
