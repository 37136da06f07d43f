// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "spatial/triangles/nodes.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstring>
#include <vector>

#include "base/random.h"

using namespace jalon;
using namespace jalon::triangle_tree;

namespace {

FloatBox box_at(float x, float y, float z, float size) {
  FloatBox box;
  const float low[3] = {x, y, z};
  for (int axis = 0; axis < 3; ++axis) {
    box.min[axis] = low[axis];
    box.max[axis] = low[axis] + size;
  }
  return box;
}

std::vector<FloatBox> random_boxes(size_t n, uint64_t seed) {
  RandomStream random(seed, 0);
  const auto coordinate = [&] { return static_cast<float>(100 * random.uniform()); };
  std::vector<FloatBox> boxes;
  for (size_t i = 0; i < n; ++i) {
    const float x = coordinate(), y = coordinate(), z = coordinate();
    boxes.push_back(box_at(x, y, z, static_cast<float>(random.uniform())));
  }
  return boxes;
}

Nodes nodes_of(const std::vector<FloatBox>& boxes, uint32_t leaf_size, unsigned threads = 2) {
  Task::Hooks hooks;
  hooks.threads = threads;
  Task task(hooks);
  return build_nodes(boxes, leaf_size, 1, task);
}

bool holds(const FloatBox& outer, const FloatBox& inner) {
  for (int axis = 0; axis < 3; ++axis)
    if (inner.min[axis] < outer.min[axis] || inner.max[axis] > outer.max[axis]) return false;
  return true;
}

/// What a walk from the root finds.
struct Walk {
  const Nodes& tree;
  const std::vector<FloatBox>& boxes;
  std::vector<int> visits;
  uint32_t largest_leaf = 0;
  size_t deepest = 0, outside = 0;

  Walk(const Nodes& nodes, const std::vector<FloatBox>& all)
      : tree(nodes), boxes(all), visits(all.size(), 0) {
    FloatBox everything;
    for (const FloatBox& box : all) everything.add(box);
    visit(0, everything, 1);
  }
  void visit(uint32_t index, const FloatBox& parent, size_t depth) {
    deepest = std::max(deepest, depth);
    const Node& node = tree.nodes[index];
    for (uint32_t i = 0; i < kWidth; ++i) {
      if (node.count[i] == 0 && node.child[i] == 0) {
        CHECK(node.bounds[0][i] > node.bounds[1][i]);  // an unused place is an empty box
        continue;
      }
      FloatBox own;
      for (int axis = 0; axis < 3; ++axis) {
        own.min[axis] = node.bounds[2 * axis][i];
        own.max[axis] = node.bounds[2 * axis + 1][i];
      }
      outside += !holds(parent, own);
      if (node.count[i] == 0) {
        visit(node.child[i], own, depth + 1);
        continue;
      }
      largest_leaf = std::max(largest_leaf, node.count[i]);
      for (uint32_t k = node.child[i]; k < node.child[i] + node.count[i]; ++k) {
        const uint32_t triangle = tree.order[k];
        ++visits[triangle];
        outside += !holds(own, boxes[triangle]);
      }
    }
  }
  bool each_once() const {
    return std::count(visits.begin(), visits.end(), 1) == static_cast<ptrdiff_t>(visits.size());
  }
};

}  // namespace

TEST_CASE("triangle_nodes__hold_each_box_in_one_leaf_within_the_bounds_above_it") {
  for (const size_t n : {1, 2, 5, 9, 3000})
    for (const uint32_t leaf_size : {1u, 2u, 4u}) {
      CAPTURE(n);
      const auto boxes = random_boxes(n, n);
      const Nodes tree = nodes_of(boxes, leaf_size);
      const Walk walk(tree, boxes);
      CHECK(walk.each_once());
      CHECK(walk.outside == 0);
      CHECK(walk.largest_leaf <= leaf_size);
      CHECK(walk.deepest * (kWidth - 1) < kStackSize);
    }
}

TEST_CASE("triangle_nodes__of_equal_boxes_and_of_very_uneven_ones_fit_the_stack") {
  const std::vector<FloatBox> equal(500, box_at(1, 2, 3, 4));
  std::vector<FloatBox> uneven;  // each half of the one before: every split by area parts one off
  for (float size = 1e30f; size > 1e-30f; size *= 0.5f) uneven.push_back(box_at(size, 0, 0, size));
  for (const auto& boxes : {equal, uneven}) {
    const Nodes tree = nodes_of(boxes, 2);
    const Walk walk(tree, boxes);
    CHECK(walk.each_once());
    CHECK(walk.outside == 0);
    CHECK(walk.largest_leaf <= 2);
    CHECK(walk.deepest * (kWidth - 1) < kStackSize);
  }
}

TEST_CASE("triangle_nodes__of_nothing_are_none") {
  const Nodes tree = nodes_of({}, 2);
  CHECK(tree.nodes.empty());
  CHECK(tree.order.empty());
}

TEST_CASE("triangle_nodes__are_the_same_for_any_number_of_threads") {
  const auto boxes = random_boxes(20000, 7);
  const Nodes one = nodes_of(boxes, 4, 1), four = nodes_of(boxes, 4, 4);
  CHECK(one.order == four.order);
  REQUIRE(one.nodes.size() == four.nodes.size());
  CHECK(std::memcmp(one.nodes.data(), four.nodes.data(), one.nodes.size() * sizeof(Node)) == 0);
}
