// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/las/copc_tree.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

#include "unit/formats/las/copc_files.h"

using namespace jalon;
using namespace jalon::test;

namespace {

using Name = std::tuple<int, int, int, int>;
Name name_of(const las::CopcKey& key) { return {key.level, key.x, key.y, key.z}; }

las::CopcTree tree_of(const Cloud& cloud, unsigned threads = 0) {
  Task::Hooks hooks;
  hooks.threads = threads;
  Task task(hooks);
  Buffer<double> xyz(cloud.xyz().size());
  std::ranges::copy(cloud.xyz(), xyz.begin());
  return las::copc_tree(std::move(xyz), task);
}

Vec3 low_corner(const las::CopcTree& tree) {
  return tree.centre - Vec3{tree.halfsize, tree.halfsize, tree.halfsize};
}

/// The cell of the tree's cube at a level that a point is in.
Name cell_of(const las::CopcTree& tree, const Vec3& p, int level) {
  const Vec3 at = (p - low_corner(tree)) * (std::ldexp(1, level) / (2 * tree.halfsize));
  return {level, static_cast<int>(std::floor(at.x)), static_cast<int>(std::floor(at.y)),
          static_cast<int>(std::floor(at.z))};
}

/// Whether the cell holds the point, up to what doubles of seven digits before the point round.
bool holds(const las::CopcTree& tree, const las::CopcKey& key, const Vec3& p) {
  constexpr double kRounding_m = 1e-8;
  const double edge = std::ldexp(2 * tree.halfsize, -key.level);
  const Vec3 low = low_corner(tree) + Vec3{double(key.x), double(key.y), double(key.z)} * edge;
  bool inside = true;
  for (int k = 0; k < 3; ++k)
    inside = inside && p[k] >= low[k] - kRounding_m && p[k] <= low[k] + edge + kRounding_m;
  return inside;
}

}  // namespace

TEST_CASE("copc_tree__every_point_is_in_one_node_whose_cell_holds_it_and_parents_are_there") {
  for (const uint64_t seed : {1u, 2u}) {
    const Cloud cloud = wall_and_ground(70000, seed);
    const las::CopcTree tree = tree_of(cloud);
    REQUIRE(tree.order.size() == cloud.size());
    CHECK(std::set<uint32_t>(tree.order.begin(), tree.order.end()).size() == cloud.size());
    std::set<Name> names;
    size_t next = 0, strangers = 0;
    for (const las::CopcTree::Node& node : tree.nodes) {
      CHECK(node.first == next);
      CHECK(node.count > 0);
      next += node.count;
      const las::CopcKey& key = node.key;
      CHECK(names.insert(name_of(key)).second);
      if (key.level > 0)
        CHECK(names.contains(Name{key.level - 1, key.x / 2, key.y / 2, key.z / 2}));
      for (size_t i = 0; i < node.count; ++i)
        strangers += holds(tree, key, cloud.point(tree.order[node.first + i])) ? 0 : 1;
    }
    CHECK(next == cloud.size());
    CHECK(strangers == 0);
    CHECK(tree.nodes.size() > 4);
  }
}

TEST_CASE("copc_tree__a_node_with_children_keeps_one_point_a_cell_of_its_grid_and_crumbs_of_them") {
  const Cloud cloud = wall_and_ground(70000, 3);
  const las::CopcTree tree = tree_of(cloud);
  std::set<Name> parents;
  for (const las::CopcTree::Node& node : tree.nodes)
    parents.insert({node.key.level - 1, node.key.x / 2, node.key.y / 2, node.key.z / 2});
  size_t looked_at = 0;
  for (const las::CopcTree::Node& node : tree.nodes) {
    if (!parents.contains(name_of(node.key))) continue;
    std::set<Name> cells;
    for (size_t i = 0; i < node.count; ++i)
      cells.insert(cell_of(tree, cloud.point(tree.order[node.first + i]),
                           node.key.level + las::kCopcGridLevels));
    CHECK(node.count - cells.size() < 8 * 100);
    ++looked_at;
  }
  CHECK(looked_at > 1);
  CHECK(tree.spacing == std::ldexp(2 * tree.halfsize, -las::kCopcGridLevels));
  Task task;
  const Box3 box = bounds(cloud, task);
  CHECK(2 * tree.halfsize == box.max.x - box.min.x);
  for (int k = 0; k < 3; ++k) CHECK(std::fabs(low_corner(tree)[k] - box.min[k]) < 1e-8);
}

TEST_CASE("copc_tree__the_same_for_any_number_of_threads") {
  const Cloud cloud = wall_and_ground(60000, 4);
  const las::CopcTree one = tree_of(cloud, 1);
  for (const unsigned threads : {2u, 3u}) {
    const las::CopcTree other = tree_of(cloud, threads);
    CHECK(other.order == one.order);
    REQUIRE(other.nodes.size() == one.nodes.size());
    for (size_t i = 0; i < one.nodes.size(); ++i) {
      CHECK(name_of(other.nodes[i].key) == name_of(one.nodes[i].key));
      CHECK(other.nodes[i].first == one.nodes[i].first);
    }
  }
}

TEST_CASE("copc_tree__no_points_one_point_and_equal_points_end") {
  CHECK(tree_of(Cloud{}).nodes.empty());
  const las::CopcTree one = tree_of(random_points(1, 1));
  REQUIRE(one.nodes.size() == 1);
  CHECK(one.nodes[0].count == 1);
  Buffer<double> equal(3 * 20000);
  for (size_t i = 0; i < equal.size(); ++i) equal[i] = 7;
  const las::CopcTree deep = tree_of(make_cloud(std::move(equal)));
  size_t points = 0;
  for (const las::CopcTree::Node& node : deep.nodes) points += node.count;
  CHECK(points == 20000);
  CHECK(deep.nodes.size() < 32);
}
