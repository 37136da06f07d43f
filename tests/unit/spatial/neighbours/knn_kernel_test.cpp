// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include "unit/spatial/octree_fixture.h"

using namespace jalon;
using namespace jalon::test;

TEST_CASE("knn_kernel__equals_brute_force_for_one_neighbour_and_for_the_most") {
  const auto xyz = street(3000);
  const auto tree = build(xyz);
  for (const uint32_t k : {1u, 5u, 256u}) {
    CAPTURE(k);
    const AllNeighbours all = all_knn(*tree, k);
    for (size_t i = 0; i < tree->size(); i += 37) {
      const auto truth = brute_force(xyz, point(xyz, i), k);
      for (size_t j = 0; j < k; ++j) {
        REQUIRE(all.index[i * k + j] == truth[j].index);
        REQUIRE(all.squared[i * k + j] == doctest::Approx(truth[j].squared_distance).epsilon(1e-5));
      }
    }
  }
}
