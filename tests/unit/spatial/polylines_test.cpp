// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "spatial/polylines.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "base/random.h"

using namespace jalon;

namespace {

double off_chord(const Vec2& p, const Vec2& a, const Vec2& b) {
  const Vec2 d = b - a, e = p - a;
  return std::fabs(d.u * e.v - d.v * e.u) / std::hypot(d.u, d.v);
}

}  // namespace

TEST_CASE("polylines__simplify_keeps_corners_and_all_points_within_the_tolerance") {
  std::vector<Vec2> chain;
  for (int i = 0; i <= 20; ++i) chain.push_back({0.1 * i, 0});
  for (int i = 1; i <= 10; ++i) chain.push_back({2, 0.1 * i});
  CHECK(simplify(chain, 0.01) == std::vector<uint32_t>{0, 20, 30});
  RandomStream random(4, 0);
  std::vector<Vec2> walk{{0, 0}};
  for (int i = 0; i < 500; ++i)
    walk.push_back(walk.back() + Vec2{random.normal() + 0.5, random.normal()});
  for (const double tolerance : {0.1, 1.0, 5.0}) {
    const auto kept = simplify(walk, tolerance);
    REQUIRE(kept.front() == 0);
    REQUIRE(kept.back() == 500);
    for (size_t k = 0; k + 1 < kept.size(); ++k)
      for (uint32_t i = kept[k] + 1; i < kept[k + 1]; ++i)
        CHECK(off_chord(walk[i], walk[kept[k]], walk[kept[k + 1]]) <= tolerance);
  }
}

TEST_CASE("polylines__simplify_takes_closed_short_and_repeated_chains") {
  CHECK(simplify({}, 0.1).empty());
  CHECK(simplify(std::vector<Vec2>{{1, 1}}, 0.1).size() == 1);
  CHECK(simplify(std::vector<Vec2>(5, {1, 1}), 0.1) == std::vector<uint32_t>{0, 4});
  const std::vector<Vec2> square{{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}};
  CHECK(simplify(square, 0.1) == std::vector<uint32_t>{0, 1, 2, 3, 4});
}

TEST_CASE("polylines__chains_follow_a_wall_and_break_at_gaps") {
  Task task;
  RandomStream random(7, 0);
  std::vector<Vec2> points;
  for (int i = 0; i < 400; ++i)
    points.push_back({4 * random.uniform() + (i < 200 ? 0 : 5), 0.003 * random.normal() + 0.05});
  std::vector<uint32_t> order;
  const auto nodes = thin_points(points, 0.1, order, task);
  uint32_t counted = 0;
  for (const ProfileNode& node : nodes) counted += node.count;
  CHECK(counted == 400);
  const auto chains = chain_nodes(nodes, 0.1, 0.5, task);
  REQUIRE(chains.size() == 2);
  size_t used = 0;
  for (const auto& chain : chains) {
    used += chain.size();
    for (size_t i = 0; i + 1 < chain.size(); ++i)  // along the wall, never back
      CHECK((nodes[chain[i + 1]].middle.u > nodes[chain[i]].middle.u) ==
            (nodes[chain[1]].middle.u > nodes[chain[0]].middle.u));
  }
  CHECK(used == nodes.size());
}

TEST_CASE("polylines__the_fullest_neighbour_is_of_the_eight_cells_about") {
  Task task;
  const std::vector<ProfileNode> nodes{{{0.5, 0.5}, 0, 2},
                                       {{0.5, 1.5}, 2, 5},
                                       {{1.5, 1.5}, 7, 5},
                                       {{2.5, 0.5}, 12, 9},
                                       {{9, 9}, 21, 1}};
  CHECK(fullest_neighbours(nodes, 1, task) == std::vector<uint32_t>{1, 2, 3, 2, 4});
}

TEST_CASE("polylines__points_beyond_all_cells_have_nodes_and_neighbours") {
  Task task;
  const std::vector<Vec2> points{{0, 0}, {0.01, 0}, {1e300, -1e300}, {-1e300, 1e300}};
  std::vector<uint32_t> order;
  const auto nodes = thin_points(points, 0.02, order, task);
  CHECK(nodes.size() == 3);
  const auto into = fullest_neighbours(nodes, 0.02, task);
  for (uint32_t i = 0; i < nodes.size(); ++i) CHECK(into[i] == i);
  CHECK(chain_nodes(nodes, 0.02, 0.1, task).size() == 3);
}
