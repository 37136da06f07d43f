// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Surfaces along a cylinder, on made rows of points whose surfaces are known.
#include "compare/m3c2/surfaces.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "base/random.h"

using namespace jalon;

namespace {

/// n places, 1 mm apart.
void add_row(std::vector<double>& out, double from, size_t n) {
  for (size_t i = 0; i < n; ++i) out.push_back(from + 0.001 * static_cast<double>(i));
}

std::vector<CylinderSurface> found_in(const std::vector<double>& ascending, double gap_m,
                                      uint32_t min_points = 5) {
  SurfaceFinder finder(gap_m, min_points);
  const auto found = finder(ascending);
  return {found.begin(), found.end()};
}

}  // namespace

TEST_CASE("cylinder_surfaces__are_runs_between_wider_gaps_and_single_points_join_none") {
  std::vector<double> t{-0.4};
  add_row(t, 0, 20);
  t.push_back(0.06);  // as near to both as points of one surface may be
  add_row(t, 0.1, 30);
  add_row(t, 0.6, 4);
  const auto found = found_in(t, 0.05);
  REQUIRE(found.size() == 2);
  CHECK(found[0].first == 1);
  CHECK(found[0].count == 20);
  CHECK(found[1].first == 22);
  CHECK(found[1].count == 30);
  CHECK(found_in(t, 0.05, 4).size() == 3);
  CHECK(found_in(t, 0.05, 25).size() == 1);
}

TEST_CASE("cylinder_surfaces__a_gap_of_nothing_or_wider_than_all_makes_one") {
  std::vector<double> t;
  add_row(t, -0.5, 7);
  add_row(t, 0.5, 7);
  for (const double gap_m : {0.0, 1.01, 5.0}) {
    const auto found = found_in(t, gap_m);
    REQUIRE(found.size() == 1);
    CHECK(found[0].first == 0);
    CHECK(found[0].count == 14);
  }
  CHECK(found_in(t, 0.1).size() == 2);
  for (const double gap_m : {0.0, 0.1, 5.0}) CHECK(found_in(t, gap_m, 15).empty());
  CHECK(found_in({}, 0.1).empty());
}

TEST_CASE("cylinder_surfaces__keep_rough_ones_whole_and_are_the_same_seen_from_behind") {
  for (uint64_t stream = 0; stream < 20; ++stream) {
    RandomStream random(21, stream);
    std::vector<double> t;
    for (size_t i = 0; i < 150; ++i) t.push_back(0.1 * random.normal());  // twice the gap
    for (size_t i = 0; i < 75; ++i) t.push_back(2.5 + 0.1 * random.normal());
    std::sort(t.begin(), t.end());
    const auto found = found_in(t, 0.05);
    REQUIRE(found.size() == 2);
    // Beyond 3 sigma, where company may lack, lies less than 1 in 300.
    CHECK(found[0].count >= 148);
    CHECK(found[1].count >= 73);
    std::vector<double> behind(t.rbegin(), t.rend());
    for (double& x : behind) x = -x;
    const auto turned = found_in(behind, 0.05);
    REQUIRE(turned.size() == 2);
    CHECK(turned[0].first == t.size() - found[1].first - found[1].count);
    CHECK(turned[0].count == found[1].count);
    CHECK(turned[1].count == found[0].count);
  }
}

TEST_CASE("cylinder_surfaces__that_are_compared_are_the_nearest_to_the_core_and_to_each_other") {
  std::vector<double> a, b;
  add_row(a, -0.5, 10);
  add_row(a, -0.005, 10);  // the core point lies in it
  add_row(b, -0.1, 10);
  add_row(b, 0.07, 10);
  const std::vector<CylinderSurface> two{{0, 10}, {10, 10}}, upper{{10, 10}}, lower{{0, 10}};
  const SurfacePair pair = nearest_surfaces(a, two, b, two);
  CHECK(pair.reference == 1);
  CHECK(pair.compared == 1);
  // Without it b's upper surface, 0.07 m away, is nearest, and a has one left.
  CHECK(nearest_surfaces(a, lower, b, two).compared == 1);
  // Swapping the clouds swaps the answer.
  for (const auto* of_a : {&two, &upper, &lower})
    for (const auto* of_b : {&two, &upper, &lower}) {
      const SurfacePair forth = nearest_surfaces(a, *of_a, b, *of_b),
                        back = nearest_surfaces(b, *of_b, a, *of_a);
      CHECK(forth.reference == back.compared);
      CHECK(forth.compared == back.reference);
    }
}
