// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "spatial/neighbours/ball_ranges.h"

#include <doctest/doctest.h>

#include "unit/spatial/hostile_clouds.h"
#include "unit/spatial/octree_fixture.h"

using namespace jalon;
using namespace jalon::test;

namespace {

std::vector<uint32_t> members(BallRanges& ranges, const Octree& tree, const Vec3& centre) {
  std::vector<uint32_t> out;
  uint32_t before = 0;
  for (const BallRanges::Range& range : ranges.find(centre)) {
    CHECK((out.empty() || range.first > before));  // ascending, and none that another one continues
    before = range.last;
    for (uint32_t i = range.first; i < range.last; ++i) out.push_back(tree.order()[i]);
  }
  CHECK(out.size() == ranges.points());
  std::sort(out.begin(), out.end());
  return out;
}

std::vector<uint32_t> by_brute_force(const std::vector<double>& xyz, const Vec3& q, double radius) {
  std::vector<uint32_t> out;
  for (size_t i = 0; i < xyz.size() / 3; ++i)
    if (squared_norm(point(xyz, i) - q) <= radius * radius) out.push_back(static_cast<uint32_t>(i));
  return out;
}

}  // namespace

TEST_CASE("ball_ranges__hold_the_points_of_the_closed_ball_and_no_others") {
  std::vector<HostileCloud> clouds = hostile_clouds(1500);
  clouds.push_back({"street", street(1500)});
  clouds.push_back({"street on a grid", street(1500, 2, 0.25)});
  clouds.push_back({"equal", std::vector<double>(4500, 0.25)});
  for (const HostileCloud& cloud : clouds) {
    CAPTURE(cloud.name);
    const auto tree = build(cloud.xyz);
    for (const double radius : {-1.0, 0.0, 1e-200, 1e-30, 2e-6, 0.25, 3.0, 100.0, 1e200}) {
      CAPTURE(radius);
      BallRanges ranges(tree->impl(), radius);
      for (size_t q = 0; q < 1500; q += 97) {
        const Vec3 centre = point(cloud.xyz, q);
        const auto truth =
            radius < 0 ? std::vector<uint32_t>{} : by_brute_force(cloud.xyz, centre, radius);
        REQUIRE(members(ranges, *tree, centre) == truth);
      }
    }
  }
}

// What makes the time of a ball: not how many points it holds.
TEST_CASE("ball_ranges__look_at_little_of_a_crowd_that_they_hold") {
  for (const int n : {6000, 48000})
    for (const HostileCloud& cloud : hostile_clouds(n)) {
      if (std::string(cloud.name).find("halving") == std::string::npos &&
          std::string(cloud.name).find("pile") == std::string::npos)
        continue;
      CAPTURE(cloud.name);
      CAPTURE(n);
      const auto tree = build(cloud.xyz);
      BallRanges ranges(tree->impl(), 1e-40);
      uint64_t points = 0;
      for (size_t i = 0; i < tree->size(); ++i) {
        ranges.find(tree->impl().exact_point(i));
        points += ranges.points();
      }
      CHECK(points / tree->size() > static_cast<uint64_t>(n) / 5);
      CHECK(ranges.looked_at() / tree->size() < 500);
    }
}
