// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "scan/builder/objects.h"
#include "unit/scan/scenes/built.h"

using namespace jalon;
using namespace jalon::test;

// Obstacles against the sizes that their header tells; the crown's opacity against rays.

namespace {

Box3 bounds(const Model& model) {
  Box3 box;
  for (const Vec3& v : model.vertices) box.add(v);
  return box;
}

/// Share of the lines through the middle of this crown that a leaf stops.
double stopped_share(uint64_t seed, double radius_m, double opacity) {
  constexpr int kLines = 10;
  SceneBuilder out{Transform{}};
  add_crown(out, kNoPart, {}, radius_m, opacity, {seed, 1});
  const Model model = out.take();
  RandomStream random(seed, 2);
  int stopped = 0;
  for (int k = 0; k < kLines; ++k) {
    const Vec3 d = normalized({random.normal(), random.normal(), random.normal()});
    stopped += std::isfinite(first_hit(model, d * -2 * radius_m, d).distance);
  }
  return static_cast<double>(stopped) / kLines;
}

}  // namespace

TEST_CASE("crown__stops_the_told_share_of_the_beams_through_its_middle") {
  for (const double opacity : {0.5, 0.85}) {
    constexpr int kCrowns = 250;
    double sum = 0, squares = 0;
    for (uint64_t seed = 1; seed <= kCrowns; ++seed) {
      const double share = stopped_share(seed, 0.8, opacity);
      sum += share;
      squares += share * share;
    }
    // Lines of one crown meet the same leaves near its middle: crowns are the independent draws.
    const double mean = sum / kCrowns, variance = (squares - sum * mean) / (kCrowns - 1);
    CAPTURE(opacity);
    CHECK(std::abs(mean - opacity) < 4 * std::sqrt(variance / kCrowns));
    CHECK(4 * std::sqrt(variance / kCrowns) < 0.05);  // a fifth more or fewer leaves would show
  }
}

TEST_CASE("tree__stands_on_a_trunk_from_the_ground_to_the_middle_of_its_crown") {
  SceneBuilder out{Transform{}};
  const uint32_t parent = out.part("unwanted", "unwanted");
  add_tree(out, parent, {2, -5, 3.2}, 1.5, 0.3, {1, 1});
  const Model model = out.take();
  CHECK(model.parts.back().part_class == "tree");
  CHECK(model.parts.back().parent == parent);
  CHECK(bounds(model).min.z == 0);
  // Below the leaves a level ray meets the round trunk, 0.12 m from its axis; beside it none.
  CHECK(std::abs(front_y(model, 2, 1) + 5.12) <
        0.12 * (1 - std::cos(std::numbers::pi / 32)) + 1e-9);
  CHECK(std::isinf(front_y(model, 2.13, 1)));
  CHECK(std::isinf(front_y(model, 1.87, 1)));
}

TEST_CASE("stair__has_16_even_treads_with_light_between_them_and_posts_beside") {
  SceneBuilder out{Transform{}};
  add_stair(out, kNoPart, {10, -4, 2});
  const Model model = out.take();
  CHECK(parts_named(model, "stair").size() == 1);
  const double rise = top_z(model, 10.1, -3.5) - 2;
  CHECK(rise > 0.15);  // a stair that one can walk: Blondel's two rises and a going of 60 to 66 cm
  CHECK(2 * rise + 0.28 > 0.60);
  CHECK(2 * rise + 0.28 < 0.66);
  for (int k = 0; k < 16; ++k) {
    const double x = 10 + 0.28 * (k + 0.5);
    const double top = 2 + rise * (k + 1);
    CHECK(std::abs(top_z(model, x, -3.5) - top) < kRounding_m);
    CHECK(std::isinf(top_z(model, x + 0.135, -3.5)));  // between two treads
    const double thickness = top - 2 - first_hit(model, {x, -3.5, 2}, {0, 0, 1}).distance;
    CHECK(thickness > 0);
    CHECK(thickness < 0.05);
  }
  CHECK(std::isinf(top_z(model, 10 + 0.28 * 16.5, -3.5)));
  // Posts on both sides, a rail's height over the treads beside them.
  for (const double y : {-4.03, -2.77})
    for (int i = 0; i < 5; ++i) {
      const double x = 10 + 15 * 0.28 * i / 4 + 0.03;
      const double over = top_z(model, x, y) - top_z(model, x, -3.5);
      CHECK(over > 0.9 - kRounding_m);
      CHECK(over < 0.9 + rise);
    }
}

TEST_CASE("car_and_pedestrian__have_their_sizes_and_stand_where_told") {
  SceneBuilder street{Transform{}};
  add_car(street, kNoPart, {3, -9, 0.2}, 4.5);
  const Model car = street.take();
  CHECK(norm(bounds(car).min - Vec3{3, -9, 0.2}) < kRounding_m);
  CHECK(norm(bounds(car).max - Vec3{7.5, -7.2, 1.7}) < kRounding_m);
  CHECK(open_edge_m(car) == 0);  // closed, below too
  CHECK(std::abs(shell_of(car, {}).volume_m3 - 4.5 * 1.8 * 1.5) < kRounding_m);

  SceneBuilder walk{Transform{}};
  add_pedestrian(walk, kNoPart, {5, -1, 0.2});
  const Model person = walk.take();
  CHECK(person.parts.back().part_class == "pedestrian");
  CHECK(std::abs(bounds(person).min.z - 0.2) < kRounding_m);
  CHECK(std::abs(bounds(person).max.z - 1.95) < kRounding_m);
  CHECK(std::isfinite(front_y(person, 5, 1.65)));            // no gap below 1.5 m and from 1.5 m up
  CHECK(front_y(person, 5, 1.0) < front_y(person, 5, 1.8));  // the body is wider than the head
}
