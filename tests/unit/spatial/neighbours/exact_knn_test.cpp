// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "spatial/neighbours/exact_knn.h"

#include <doctest/doctest.h>

#include "unit/spatial/hostile_clouds.h"
#include "unit/spatial/octree_fixture.h"

using namespace jalon;
using namespace jalon::test;

TEST_CASE("exact_knn__of_whole_leaves_and_of_single_points_are_those_of_brute_force") {
  for (const HostileCloud& cloud : hostile_clouds(1500)) {
    const auto built = build(cloud.xyz);
    const Octree::Impl& tree = built->impl();
    if (!tree.has_exact_boxes()) continue;
    CAPTURE(cloud.name);
    for (const uint32_t k : {1u, 9u, 200u}) {
      ExactKnn search(tree, k);
      std::vector<uint32_t> of_leaf(k * size_t{kLeafPoints}), of_point(k);
      for (size_t leaf = 0; leaf < tree.leaves; ++leaf) {
        search.leaf(leaf, of_leaf.data());
        const size_t first = tree.leaf_first[leaf];
        search.point(first, of_point.data());
        const auto truth = brute_force(cloud.xyz, tree.exact_point(first), k);
        for (size_t j = 0; j < k; ++j) {
          REQUIRE(tree.order[of_leaf[j]] == truth[j].index);
          REQUIRE(of_point[j] == of_leaf[j]);
        }
      }
    }
  }
}
