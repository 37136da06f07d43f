// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Planes that a thing stands on or before, against a corner of a room whose planes are known.
#include "compare/changes/support.h"

#include <doctest/doctest.h>

#include "unit/compare/changes/epochs.h"

using namespace jalon;
using namespace jalon::test;

namespace {

constexpr double kNoise_m = 0.003, kTolerance_m = 0.05;

// Floor of 3 x 3 m and a wall of 3 x 2 m at x = 0, with noise, and the top of a box of 0.8 x 0.6 x 0.7 m.
std::vector<Vec3> corner_of_a_room(uint64_t seed) {
  RandomStream random(seed, 0);
  std::vector<Vec3> points;
  add_sheet(points, {0, 0, 0}, {3, 0, 0}, {0, 3, 0}, random);
  add_sheet(points, {0, 0, 0}, {0, 3, 0}, {0, 0, 2}, random);
  add_sheet(points, {1, 1, 0.7}, {0.8, 0, 0}, {0, 0.6, 0}, random);
  for (Vec3& p : points)
    p += Vec3{kNoise_m * random.normal(), kNoise_m * random.normal(), kNoise_m * random.normal()};
  return points;
}

const Box3 kBox{{1, 1, 0.05}, {1.8, 1.6, 0.72}};

}  // namespace

TEST_CASE("find_supports__are_floor_and_wall_of_a_corner_but_not_the_top_of_the_thing") {
  for (uint64_t seed = 1; seed <= 5; ++seed) {
    const auto found = find_supports(corner_of_a_room(seed), kBox, kTolerance_m, seed);
    REQUIRE(found.size() == 2);
    const Support &floor = found[0], &wall = found[1];  // the largest first
    // Within the tolerance of one plane lie the feet of the other: a 40th of its points, half of it away.
    CHECK(std::abs(floor.plane.normal.z) > 0.9995);
    CHECK(std::abs(wall.plane.normal.x) > 0.9995);
    CHECK(std::abs(floor.plane.distance({1.5, 1.5, 0})) < 0.004);
    CHECK(std::abs(wall.plane.distance({0, 1.5, 1})) < 0.004);
    for (const Support& support : found) {
      CHECK(support.tolerance_m > 3 * kNoise_m);
      CHECK(support.tolerance_m <= kTolerance_m);
      CHECK(support.goes_beyond(kBox));
    }
    // 3 and 3 m, 3 and 2 m, and noise at both ends.
    CHECK(floor.width_u_m * floor.width_v_m > 8.5);
    CHECK(wall.width_u_m * wall.width_v_m == doctest::Approx(6).epsilon(0.05).scale(0));
    CHECK(floor.holds({2.5, 2.5, 0}));
    CHECK_FALSE(floor.holds({2.5, 2.5, 0.06}));
  }
}

TEST_CASE("find_supports__are_none_where_points_are_few_or_fill_a_space_or_end_with_the_change") {
  RandomStream random(2, 0);
  const Box3 small{{-0.1, -0.1, -0.1}, {0.1, 0.1, 0.1}};
  std::vector<Vec3> few, cloud, top;
  for (int i = 0; i < 49; ++i) few.push_back({random.uniform(), random.uniform(), 0});
  CHECK(find_supports(few, small, kTolerance_m, 1).empty());
  few.push_back({0.5, 0.5, 0});
  CHECK(find_supports(few, small, kTolerance_m, 1).size() == 1);
  // A plane holds some 2 x 0.01 of a space of 1 m: less than the tenth that it needs.
  for (int i = 0; i < 3000; ++i)
    cloud.push_back({random.uniform(), random.uniform(), random.uniform()});
  CHECK(find_supports(cloud, small, 0.01, 1).empty());
  add_sheet(top, {-1, -1, 1}, {2, 0, 0}, {0, 2, 0}, random);
  CHECK(find_supports(top, {{-1, -1, 0}, {1, 1, 0.9}}, kTolerance_m, 1).empty());
  CHECK(find_supports(top, {{-0.5, -0.5, 0}, {0.5, 0.5, 0.9}}, kTolerance_m, 1).size() == 1);
  // Half of its 4 m2 have to lie beside the change: 1.6 m2 do not do, 2.3 m2 do.
  CHECK(find_supports(top, {{-0.775, -0.775, 0}, {0.775, 0.775, 1.1}}, kTolerance_m, 1).empty());
  CHECK(find_supports(top, {{-0.65, -0.65, 0}, {0.65, 0.65, 1.1}}, kTolerance_m, 1).size() == 1);
  CHECK(find_supports({}, small, kTolerance_m, 1).empty());
}

TEST_CASE("support__goes_beyond_a_thing_along_its_own_axes_only_if_a_quarter_larger_on_both") {
  const double half = std::sqrt(0.5);
  Support support;
  support.axis_u = {half, half, 0};  // turned by 45 degrees: a thing of 1 x 1 m is sqrt(2) m wide
  support.axis_v = {-half, half, 0};
  const Box3 thing{{5, 5, 0}, {6, 6, 9}};
  const double enough = 1.25 / half + 1e-9, short_of = 1.25 / half - 1e-9;
  struct {
    double u, v;
    bool expected;
  } const rows[] = {{enough, enough, true}, {short_of, enough, false}, {enough, short_of, false}};
  for (const auto& row : rows) {
    support.width_u_m = row.u;
    support.width_v_m = row.v;
    CHECK(support.goes_beyond(thing) == row.expected);
  }
}
