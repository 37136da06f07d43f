// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/codes/target_leaf.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "base/random.h"

using namespace jalon;

namespace {

constexpr double kRadius_m = 2;

/// A leaf of 0.9 x 2.1 m at depth 0 about the target at (0, 0.5), with a pane 2 cm behind it, in a
/// wall whose waves of 5 cm stand about a plane `wall_m` before it; waves_m = 0: an even wall.
std::vector<Vec3> leaf_in_wall(uint64_t seed, double wall_m, double waves_m, int points,
                               double pane_returns = 0.05, double stile_m = 0.17,
                               double rail_m = 0.4) {
  RandomStream random(seed, 0);
  std::vector<Vec3> out;
  for (int i = 0; i < points; ++i) {
    const double s = 4 * random.uniform() - 2, z = 3 * random.uniform();
    const double noise = 0.002 * random.normal();
    if (std::fabs(s) >= 0.45 || z >= 2.1)
      out.push_back({s, wall_m + waves_m * std::sin(2 * std::numbers::pi * s / 0.2) + noise, z});
    else if (std::fabs(s) >= 0.45 - stile_m || std::fabs(z - 1.05) >= 1.05 - rail_m)
      out.push_back({s, noise, z});
    else if (random.uniform() < pane_returns) out.push_back({s, -0.02 + noise, z});
  }
  for (int i = 0; i < 600; ++i)
    out.push_back({0.1 * random.uniform() - 0.05, -0.018 + 0.002 * random.normal(),
                   0.45 + 0.1 * random.uniform()});
  return out;
}

}  // namespace

TEST_CASE("target_leaf__is_found_in_waves_that_stand_before_it_and_about_it") {
  for (uint64_t seed = 1; seed <= 3; ++seed)
    for (const double wall_m : {0.0, 0.01, 0.02})
      for (const int points : {6000, 60000}) {
        CAPTURE(seed);
        CAPTURE(wall_m);
        TargetLeaf leaf;
        REQUIRE(find_leaf(leaf_in_wall(seed, wall_m, 0.025, points), {0, 0.5}, kRadius_m, leaf));
        CHECK(std::fabs(leaf.front.before(0)) < 0.002);
        for (const double wide : {leaf.left_m + 0.45, 0.45 - leaf.right_m}) {
          CHECK(wide < 0.06);  // a strip of a crest at most
          CHECK(wide > -0.08);
        }
        CHECK(std::fabs(leaf.high_m - 2.1) < 0.08);
      }
}

TEST_CASE("target_leaf__its_pane_or_panel_may_return_all") {
  for (const double wall_m : {0.01, 0.02}) {
    TargetLeaf leaf;
    REQUIRE(find_leaf(leaf_in_wall(1, wall_m, 0.025, 60000, 1), {0, 0.5}, kRadius_m, leaf));
    CHECK(std::fabs(leaf.front.before(0)) < 0.002);
    CHECK(std::fabs(leaf.high_m - 2.1) < 0.08);
    CHECK(leaf.right_m - leaf.left_m > 0.8);
  }
}

TEST_CASE("target_leaf__a_pane_in_a_narrow_frame_may_return_all_to_a_coarse_scan") {
  constexpr int kPoints = 7500;  // 4 cm apart
  constexpr double kFrame_m = 0.08;
  for (uint64_t seed = 1; seed <= 5; ++seed) {
    CAPTURE(seed);
    TargetLeaf leaf;
    REQUIRE(find_leaf(leaf_in_wall(seed, 0.01, 0.025, kPoints, 1, kFrame_m, kFrame_m), {0, 0.5},
                      kRadius_m, leaf));
    CHECK(leaf.right_m - leaf.left_m > 0.8);
  }
}

TEST_CASE("target_leaf__crests_of_a_sheet_are_none") {
  constexpr int kPoints = 60000;
  for (const bool is_trapezoidal : {false, true})
    for (const double pitch_m : {0.076, 0.1, 0.2, 0.3})
      for (const double wave_m : {0.015, 0.02, 0.025}) {
        CAPTURE(is_trapezoidal);
        CAPTURE(pitch_m);
        CAPTURE(wave_m);
        RandomStream random(1, 0);
        std::vector<Vec3> sheet;
        for (int i = 0; i < kPoints; ++i) {
          // Not cut off by the reach.
          const double s = 3.7 * random.uniform() - 1.9, z = 2.8 * random.uniform();
          double wave = std::sin(2 * std::numbers::pi * s / pitch_m);
          if (is_trapezoidal) wave = std::clamp(2 * wave, -1.0, 1.0);
          sheet.push_back({s, 0.014 + wave_m * wave + 0.002 * random.normal(), z});
        }
        TargetLeaf leaf;
        CHECK(!find_leaf(sheet, {0, 0.5}, kRadius_m, leaf));
      }
}

TEST_CASE("target_leaf__there_is_none_in_a_wall_as_even_as_itself_or_without_points") {
  TargetLeaf leaf;
  CHECK(!find_leaf(leaf_in_wall(1, 0, 0, 20000), {0, 0.5}, kRadius_m, leaf));
  CHECK(!find_leaf({}, {0, 0.5}, kRadius_m, leaf));
}
