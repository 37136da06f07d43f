// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include "base/error.h"
#include "unit/spatial/hostile_clouds.h"
#include "unit/spatial/octree_fixture.h"

using namespace jalon;
using namespace jalon::test;

namespace {

void check_against_brute_force(const std::vector<double>& xyz, uint32_t k, size_t stride) {
  const auto tree = build(xyz);
  const AllNeighbours all = all_knn(*tree, k);
  for (size_t i = 0; i < tree->size(); i += stride) {
    const auto truth = brute_force(xyz, point(xyz, i), k);
    for (size_t j = 0; j < k; ++j) {
      if (j >= truth.size()) {
        REQUIRE(all.index[i * k + j] == kNoPoint);
        continue;
      }
      REQUIRE(all.index[i * k + j] == truth[j].index);
      REQUIRE(all.squared[i * k + j] == doctest::Approx(truth[j].squared_distance).epsilon(1e-5));
    }
  }
}

}  // namespace

TEST_CASE("knn_batch__settles_the_ties_of_a_lattice_by_index") {
  std::vector<double> xyz;
  for (int i = 0; i < 9 * 9 * 9; ++i)
    for (const int c : {i % 9, i / 9 % 9, i / 81}) xyz.push_back(0.25 * c);
  for (const uint32_t k : {4u, 7u, 20u}) check_against_brute_force(xyz, k, 7);
}

TEST_CASE("knn_batch__fills_up_where_there_are_fewer_points_than_asked_for") {
  check_against_brute_force(street(1), 3, 1);
  check_against_brute_force(street(17), 30, 1);
}

TEST_CASE("knn_batch__visits_every_point_once_whatever_the_threads") {
  const auto xyz = street(5000);
  const auto tree = build(xyz);
  CHECK(all_knn(*tree, 8, 1) == all_knn(*tree, 8, 4));
  Task task;
  std::vector<uint8_t> visits(tree->size(), 0);
  tree->for_each_knn(8, task, [&](const Octree::Batch& batch) {
    for (size_t i = 0; i < batch.count; ++i) {
      ++visits[batch.first + i];
      REQUIRE(batch.neighbours[i * 8] != kNoPoint);
    }
  });
  CHECK(std::count(visits.begin(), visits.end(), 1) == 5000);
}

TEST_CASE("knn_batch__equals_brute_force_where_the_grid_does_not_tell_points_apart") {
  for (const HostileCloud& cloud : hostile_clouds(2000)) {
    CAPTURE(cloud.name);
    const auto tree = build(cloud.xyz);
    for (const uint32_t k : {1u, 12u, 40u}) {
      const AllNeighbours all = all_knn(*tree, k);
      CHECK(all == all_knn(*tree, k, 1));
      for (size_t i = 0; i < tree->size(); i += k) {
        const auto truth = brute_force(cloud.xyz, point(cloud.xyz, i), k);
        for (size_t j = 0; j < k; ++j) REQUIRE(all.index[i * k + j] == truth[j].index);
      }
    }
  }
}
