// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// How large a pattern is, and whether it is one, from points of a plane.

#include "registration/targets/pattern_extent.h"

#include <doctest/doctest.h>

#include <cmath>
#include <functional>
#include <vector>

#include "base/random.h"

using namespace jalon;

namespace {

constexpr double kPitch_m = 0.004, kNoise = 4;

std::vector<BrightPoint> field_of(const std::function<double(double, double)>& brightness,
                                  uint64_t seed, double half_m = 0.15) {
  RandomStream random(211, seed);
  std::vector<BrightPoint> out;
  const double turn = random.uniform(), c = std::cos(turn), s = std::sin(turn);
  const int n = static_cast<int>(1.5 * half_m / kPitch_m);
  for (int i = -n; i <= n; ++i)
    for (int k = -n; k <= n; ++k) {
      const double u = c * i * kPitch_m - s * k * kPitch_m, v = s * i * kPitch_m + c * k * kPitch_m;
      if (std::max(std::fabs(u), std::fabs(v)) > half_m) continue;
      out.push_back({u, v, brightness(u, v) + kNoise * random.normal()});
    }
  return out;
}

/// Four quadrants of 0.1 m in a ground.
double checker(double u, double v, double ground) {
  if (std::max(std::fabs(u), std::fabs(v)) > 0.05) return ground;
  return u * v > 0 ? 200 : 40;
}

}  // namespace

TEST_CASE("checker_extent__is_its_edge_whatever_the_ground") {
  Task task;
  for (const double ground : {200.0, 120.0, 40.0, 250.0}) {
    const auto points = field_of([&](double u, double v) { return checker(u, v, ground); }, 1);
    const auto found = checker_extent(points, 0.08, 0.25, task);
    REQUIRE(found);
    CHECK(std::fabs(found->size_m - 0.1) < std::max(4 * found->sigma_m, 0.002));
    CHECK(found->sigma_m < kPitch_m);
    CHECK(found->misfit < 0.05);
    CHECK(found->contrast_to_noise > 20);
  }
}

TEST_CASE("checker_extent__ends_on_a_dark_ground_seen_beside_the_dark_quadrants_alone") {
  Task task;
  // Behind the sheet to its left the ground is too deep to be looked at.
  auto points = field_of([](double u, double v) { return checker(u, v, 45); }, 7);
  std::erase_if(points, [](const BrightPoint& p) {
    return std::max(std::fabs(p.u), std::fabs(p.v)) > 0.051 && p.u * p.v > 0;
  });
  const auto found = checker_extent(points, 0.08, 0.25, task);
  REQUIRE(found);
  CHECK(std::fabs(found->size_m - 0.1) < kPitch_m);
}

TEST_CASE("checker_extent__ends_where_the_points_end") {
  Task task;
  const auto sheet = field_of([](double u, double v) { return checker(u, v, 0); }, 2, 0.05);
  const auto found = checker_extent(sheet, 0.08, 0.25, task);
  REQUIRE(found);
  CHECK(std::fabs(found->size_m - 0.1) < kPitch_m);
}

TEST_CASE("checker_extent__refuses_tiles_and_uneven_quadrants") {
  Task task;
  const auto tiles = field_of(
      [](double u, double v) {
        const double i = std::floor(u / 0.05) + std::floor(v / 0.05);
        return std::fmod(std::fabs(i), 2) < 0.5 ? 200 : 40;
      },
      3);
  CHECK(!checker_extent(tiles, 0.08, 0.25, task));
  const auto uneven =
      field_of([](double u, double v) { return u > 0 && v > 0 ? 120 : checker(u, v, 100); }, 4);
  CHECK(!checker_extent(uneven, 0.08, 0.25, task));
}

TEST_CASE("disc_extent__tells_a_disc_from_a_square_and_from_half_a_disc") {
  const auto disc =
      field_of([](double u, double v) { return std::hypot(u, v) < 0.05 ? 40 : 200; }, 5);
  const auto found = disc_extent(disc, 0.1, 0.0005);
  REQUIRE(found);
  CHECK(found->size_m == 0.1);
  CHECK(found->sigma_m == 0.0005);
  CHECK(found->misfit < 0.02);
  const auto square = field_of(
      [](double u, double v) { return std::max(std::fabs(u), std::fabs(v)) < 0.0443 ? 40 : 200; },
      6);  // of the same area
  const auto other = disc_extent(square, 0.1, 0.0005);
  REQUIRE(other);
  CHECK(other->misfit > 0.04);
  CHECK(found->round_chance > 0.99);
  CHECK(other->round_chance < 0.01);
  std::vector<BrightPoint> half;
  for (const BrightPoint& p : disc)
    if (p.u > 0) half.push_back(p);
  CHECK(!disc_extent(half, 0.1, 0.0005));
}
