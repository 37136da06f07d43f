// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "spatial/neighbours/range_sums.h"

#include <doctest/doctest.h>

#include "unit/spatial/octree_fixture.h"

using namespace jalon;
using namespace jalon::test;

namespace {

std::vector<Octree::PointRange> random_ranges(size_t n, RandomStream& random) {
  std::vector<uint32_t> ends;
  for (int i = 0; i < 6; ++i) ends.push_back(static_cast<uint32_t>(random.below(n + 1)));
  std::sort(ends.begin(), ends.end());
  return {{ends[0], ends[1]}, {ends[2], ends[3]}, {ends[4], ends[5]}};
}

}  // namespace

TEST_CASE("range_sums__are_those_of_the_points_one_by_one_seen_from_anywhere") {
  RandomStream random(5, 0);
  for (const size_t n :
       {size_t{1}, size_t{63}, size_t{64}, size_t{65}, size_t{513}, size_t{9000}}) {
    CAPTURE(n);
    const auto tree = build(street(n));
    Task task;
    const RangeSums<4> sums(*tree, task);
    for (int k = 0; k < 60; ++k) {
      auto ranges = random_ranges(n, random);
      if (k == 0) ranges = {{0, static_cast<uint32_t>(n)}};
      const Vec3 from = grid_place(*tree, random.below(n)) + Vec3{0.5, 0, -0.25};
      PowerSums<4> truth;
      double reach = 1;
      for (const Octree::PointRange& range : ranges)
        for (size_t i = range.first; i < range.last; ++i) {
          truth.add(grid_place(*tree, i) - from);
          reach = std::max(reach, norm(grid_place(*tree, i) - from));
        }
      const PowerSums<4> found = sums.over(ranges, from);
      CHECK(found.count() == truth.count());
      for (const auto& [a, b, c] :
           {std::array{1, 0, 0}, {0, 1, 1}, {2, 0, 0}, {1, 1, 1}, {0, 0, 4}, {2, 2, 0}})
        CHECK(std::fabs(found.of(a, b, c) - truth.of(a, b, c)) <=
              1e-12 * truth.count() * std::pow(reach, a + b + c));
    }
  }
}

TEST_CASE("range_sums__have_the_same_bits_for_any_number_of_threads_and_none_of_no_points") {
  const auto tree = build(street(40000));
  Task one(threads(1)), five(threads(5));
  const RangeSums<2> a(*tree, one), b(*tree, five);
  RandomStream random(6, 0);
  for (int k = 0; k < 100; ++k) {
    const auto ranges = random_ranges(40000, random);
    const Vec3 from = grid_place(*tree, random.below(40000));
    const PowerSums<2> x = a.over(ranges, from), y = b.over(ranges, from);
    CHECK(x.of(1, 0, 0) == y.of(1, 0, 0));
    CHECK(x.of(0, 2, 0) == y.of(0, 2, 0));
    CHECK(x.of(0, 1, 1) == y.of(0, 1, 1));
  }
  const auto empty = build({});
  CHECK(RangeSums<2>(*empty, one).over({}, {}).count() == 0);
}
