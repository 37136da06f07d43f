// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "spatial/octree/other_within.h"
#include "unit/spatial/hostile_clouds.h"
#include "unit/spatial/octree_fixture.h"

using namespace jalon;
using namespace jalon::test;

namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

/// A lattice of n^3 whole coordinates: distances are exact and full of ties.
std::vector<double> lattice(int n) {
  std::vector<double> xyz;
  for (int x = 0; x < n; ++x)
    for (int y = 0; y < n; ++y)
      for (int z = 0; z < n; ++z)
        for (const int c : {x, y, z}) xyz.push_back(c);
  return xyz;
}

}  // namespace

TEST_CASE("query__knn_settles_ties_on_a_lattice_by_index_like_brute_force") {
  const auto xyz = lattice(8);
  const auto tree = build(xyz);
  for (const Vec3& q : {Vec3{3, 3, 3}, Vec3{3.5, 3.5, 3.5}, Vec3{-50, 4, 4}, Vec3{7, 7, 7.5}})
    for (const uint32_t k : {1u, 7u, 8u, 27u, 600u}) {
      std::vector<Neighbour> out(k);
      const size_t found = tree->knn(q, k, out);
      const auto truth = brute_force(xyz, q, k);
      REQUIRE(found == truth.size());
      for (size_t i = 0; i < found; ++i) {
        REQUIRE(out[i].index == truth[i].index);
        REQUIRE(out[i].squared_distance == truth[i].squared_distance);
      }
    }
}

TEST_CASE("query__another_point_is_within_the_closed_ball_or_not_like_brute_force") {
  std::vector<double> xyz = lattice(5);
  for (const double stray :
       {20.0, 20.5, 1e6, 1e6, -7.0})  // two that are near each other, a pile of two, one alone
    for (const double c : {stray, 2.0, 2.0}) xyz.push_back(c);
  const auto tree = build(xyz);
  std::vector<Neighbour> ball;
  for (size_t s = 0; s < tree->size(); ++s)
    for (const double radius : {-1.0, 0.0, 0.49, 0.5, 0.999999, 1.0, 8.9, 9.0, kInfinite}) {
      const double* p = &xyz[3 * tree->order()[s]];
      tree->radius({p[0], p[1], p[2]}, radius, ball);
      REQUIRE(has_other_within(*tree, s, radius) == (ball.size() > 1));
    }
  const auto pile = build(std::vector<double>(3 * 100, 4.0));
  CHECK(has_other_within(*pile, 50, 0));
}

TEST_CASE("query__the_ball_is_closed_and_its_points_ascend") {
  const auto xyz = lattice(7);
  const auto tree = build(xyz);
  std::vector<Neighbour> out;
  // About (3, 3, 3): 1 + 6 points within 1, 12 more at sqrt(2), 8 more at sqrt(3), 6 more at 2.
  tree->radius({3, 3, 3}, 1, out);
  CHECK(out.size() == 7);
  tree->radius({3, 3, 3}, 0.999999, out);
  CHECK(out.size() == 1);
  tree->radius({3, 3, 3}, 2, out);
  CHECK(out.size() == 33);
  for (size_t i = 1; i < out.size(); ++i) CHECK(out[i - 1].index < out[i].index);
  tree->radius({3, 3, 3}, 0, out);
  REQUIRE(out.size() == 1);
  CHECK(out[0].squared_distance == 0);
  tree->radius({100, 3, 3}, 5, out);
  CHECK(out.empty());
}

TEST_CASE("query__sorted_positions_name_the_same_points_as_indices") {
  const auto xyz = street(3000);
  const auto tree = build(xyz);
  RandomStream random(5, 0);
  for (int i = 0; i < 20; ++i) {
    const Vec3 q{20 * random.uniform(), 20 * random.uniform(), 0};
    std::vector<Neighbour> by_index(9), by_position(9);
    tree->knn(q, 9, by_index);
    tree->knn_positions(q, 9, by_position);
    for (size_t j = 0; j < 9; ++j) CHECK(tree->order()[by_position[j].index] == by_index[j].index);
    tree->radius(q, 1.5, by_index);
    tree->radius_positions(q, 1.5, by_position);
    std::vector<uint32_t> named;
    for (size_t j = 0; j < by_position.size(); ++j) {
      if (j > 0) CHECK(by_position[j - 1].index < by_position[j].index);
      named.push_back(tree->order()[by_position[j].index]);
    }
    std::sort(named.begin(), named.end());
    REQUIRE(named.size() == by_index.size());
    for (size_t j = 0; j < named.size(); ++j) CHECK(named[j] == by_index[j].index);
  }
}

TEST_CASE("query__nearest_within_takes_the_limit_itself_and_the_smallest_index") {
  const auto xyz = lattice(4);
  const auto tree = build(xyz);
  Neighbour out{};
  REQUIRE(tree->nearest_within({-2, 1, 1}, 2, out));
  CHECK(out.index == brute_force(xyz, {-2, 1, 1}, 1)[0].index);
  CHECK(out.squared_distance == 4);
  CHECK_FALSE(tree->nearest_within({-2, 1, 1}, 1.999999, out));
  REQUIRE(tree->nearest_within({1.5, 1.5, 1.5}, kInfinite, out));
  CHECK(out.index == brute_force(xyz, {1.5, 1.5, 1.5}, 1)[0].index);
}

TEST_CASE("query__an_empty_tree_answers_nothing") {
  Task task;
  const auto tree = Octree::build({}, Cube{}, task);
  std::vector<Neighbour> out(3);
  CHECK(tree->knn({0, 0, 0}, 3, out) == 0);
  Neighbour one{};
  CHECK_FALSE(tree->nearest_within({0, 0, 0}, kInfinite, one));
  tree->radius({0, 0, 0}, 1e9, out);
  CHECK(out.empty());
}

TEST_CASE("query__equals_brute_force_where_the_grid_does_not_tell_points_apart") {
  for (const HostileCloud& cloud : hostile_clouds(2000)) {
    CAPTURE(cloud.name);
    const auto tree = build(cloud.xyz);
    std::vector<Neighbour> out(9);
    for (size_t i = 0; i < 2000; i += 29)
      for (const double beside_m : {0.0, 1e-11, 0.4}) {
        const Vec3 q = point(cloud.xyz, i) + Vec3{beside_m, 0, -beside_m};
        const auto truth = brute_force(cloud.xyz, q, 9);
        out.resize(9);
        REQUIRE(tree->knn(q, 9, out) == 9);
        for (size_t j = 0; j < 9; ++j) {
          REQUIRE(out[j].index == truth[j].index);
          REQUIRE(out[j].squared_distance == truth[j].squared_distance);
        }
        REQUIRE(tree->nearest_within(q, std::sqrt(truth[0].squared_distance) * 1.01, out[0]));
        CHECK(out[0].index == truth[0].index);
        const double radius = std::sqrt(truth[8].squared_distance);
        const auto all = brute_force(cloud.xyz, q, 2000);
        size_t inside = 0;
        while (inside < 2000 && all[inside].squared_distance <= radius * radius) ++inside;
        tree->radius(q, radius, out);
        REQUIRE(out.size() == inside);
      }
  }
}
