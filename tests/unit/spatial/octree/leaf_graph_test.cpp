// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "spatial/octree/leaf_graph.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "unit/spatial/octree_fixture.h"

using namespace jalon;
using namespace jalon::test;

namespace {

Box3 box_of(const Octree& tree, size_t first, size_t last) {
  Box3 box;
  for (size_t i = first; i < last; ++i) box.add(tree.local(i));
  return box;
}

// Largest gap between two boxes on an axis; negative where they overlap on all.
double gap(const Box3& a, const Box3& b) {
  double widest = -1;
  for (int k = 0; k < 3; ++k) widest = std::max({widest, a.min[k] - b.max[k], b.min[k] - a.max[k]});
  return widest;
}

}  // namespace

TEST_CASE("leaf_graph__equals_brute_force_over_the_boxes") {
  const auto xyz = street(6000);
  const auto tree = build(xyz);
  const auto first = leaf_firsts(*tree);
  const size_t leaves = first.size() - 1;
  CHECK(first[leaves] == tree->size());
  std::vector<float> reach(leaves);
  for (size_t i = 0; i < leaves; ++i)
    reach[i] = i % 7 == 0 ? -1.0f : 0.05f * static_cast<float>(i % 5);
  Task task;
  const LeafGraph graph = leaf_graph(*tree, reach, task);
  std::vector<Box3> boxes;
  for (size_t i = 0; i < leaves; ++i) boxes.push_back(box_of(*tree, first[i], first[i + 1]));
  size_t edges = 0, wrong = 0;
  for (size_t i = 0; i < leaves; ++i) {
    const auto near = graph.of(i);
    CHECK(std::is_sorted(near.begin(), near.end()));
    CHECK(first[i + 1] - first[i] <= kMostLeafPoints);
    edges += near.size();
    if (near.size() == 64) continue;  // cut off
    const double rounding = 2 * tree->grid_step();
    for (size_t k = 0; k < leaves; ++k) {
      const bool listed = std::binary_search(near.begin(), near.end(), static_cast<uint32_t>(k));
      const double apart = gap(boxes[i], boxes[k]);
      if (k == i || reach[i] < 0) wrong += listed;
      else if (std::abs(apart - reach[i]) > rounding && (apart > 0 || reach[i] > 0))
        wrong += listed != (apart < reach[i]);
    }
  }
  CHECK(edges > leaves);
  CHECK(wrong == 0);
}

TEST_CASE("leaf_graph__bounds_the_neighbours_in_a_pile_of_duplicates") {
  std::vector<double> xyz;
  for (int i = 0; i < 20000; ++i) xyz.insert(xyz.end(), {1, 2, 3});
  xyz.insert(xyz.end(), {9, 2, 3});
  const auto tree = build(xyz);
  const std::vector<float> reach(leaf_firsts(*tree).size() - 1, 0.0f);
  Task task;
  const LeafGraph graph = leaf_graph(*tree, reach, task);
  for (size_t i = 0; i < reach.size(); ++i) REQUIRE(graph.of(i).size() <= 64);
}
