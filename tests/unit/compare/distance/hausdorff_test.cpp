// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Hausdorff distances by the properties that define them: what a metric of sets must do, and a known outlier.
#include "compare/distance/hausdorff.h"

#include <doctest/doctest.h>

#include "unit/compare/distance_fixture.h"

using namespace jalon;
using namespace jalon::test;

namespace {

double directed(const CloudPtr& from, const CloudPtr& to, unsigned threads = 2) {
  Task::Hooks hooks;
  hooks.threads = threads;
  Task task(hooks);
  return directed_hausdorff(*from->octree(task), *to->octree(task), task);
}

double both_ways(const CloudPtr& a, const CloudPtr& b) {
  return std::max(directed(a, b), directed(b, a));
}

}  // namespace

TEST_CASE("hausdorff__of_a_subset_is_0_one_way_and_that_of_the_farthest_point_the_other") {
  std::vector<double> part = random_square(5000, 1, 0, 1), whole = part;
  const double outliers[] = {0.5, 0.5, 3, 0.25, 0.5, -4};
  whole.insert(whole.begin() + 3000, std::begin(outliers), std::end(outliers));
  const auto a = cloud_of(part), b = cloud_of(whole);
  CHECK(directed(a, b) == 0);
  // 4 m below the square; that no point lies within 0.06 m beside has a chance of e^-56.
  CHECK(directed(b, a) >= 4);
  CHECK(directed(b, a) <= std::hypot(4, 0.06));
  CHECK(directed(b, a, 1) == directed(b, a, 7));
}

TEST_CASE("hausdorff__is_a_metric_and_moves_with_its_sets") {
  std::vector<CloudPtr> clouds;
  for (uint64_t seed = 1; seed <= 5; ++seed)
    clouds.push_back(
        cloud_of(random_square(40 * seed, 2, 0.1 * static_cast<double>(seed), seed, 0.3)));
  for (const CloudPtr& a : clouds) {
    CHECK(both_ways(a, a) == 0);
    for (const CloudPtr& b : clouds)
      for (const CloudPtr& c : clouds)
        REQUIRE(both_ways(a, c) <= (both_ways(a, b) + both_ways(b, c)) * (1 + 1e-15));
  }
  // A set pushed by less than half the distance between its points is off by that.
  CHECK(directed(cloud_of({0, 0, 0, 8, 0, 0, 0, 8, 0}), cloud_of({0, 0, 3, 8, 0, 3, 0, 8, 3})) ==
        3);
}

TEST_CASE("add_hausdorff__tells_each_way_by_its_name_and_the_larger_of_both") {
  const auto reference = cloud_of({0, 0, 0, 10, 0, 0}), other = cloud_of({0, 0, 1});
  Task task;
  FieldTable table;
  add_hausdorff(*reference->octree(task), *other->octree(task), task, table);
  CHECK(table.require("hausdorff_forward").number(0) == 1);
  CHECK(table.require("hausdorff_reverse").number(0) == std::sqrt(101.0));
  CHECK(table.require("hausdorff").number(0) == std::sqrt(101.0));
  FieldTable turned;
  add_hausdorff(*other->octree(task), *reference->octree(task), task, turned);
  CHECK(turned.require("hausdorff_forward").number(0) == std::sqrt(101.0));
  CHECK(turned.require("hausdorff").number(0) == std::sqrt(101.0));
}
