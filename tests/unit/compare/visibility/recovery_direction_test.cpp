// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Heights of hidden points over the reference's surface, which is known.
#include <doctest/doctest.h>

#include <cmath>

#include "compare/visibility/recovery.h"
#include "unit/cloud/clouds.h"

using namespace jalon;
using namespace jalon::test;

namespace {

/// So many points at random over a square about the origin, at the heights of the function.
template <class Height>
std::vector<Vec3> scattered_over(double side, size_t n, uint64_t stream, Height height) {
  RandomStream random(91, stream);
  std::vector<Vec3> out;
  for (size_t i = 0; i < n; ++i) {
    const double x = snapped(side * (random.uniform() - 0.5)),
                 y = snapped(side * (random.uniform() - 0.5));
    out.push_back({x, y, snapped(height(x, y))});
  }
  return out;
}

std::vector<double> heights_over(const std::vector<Vec3>& surface, const std::vector<Vec3>& points,
                                 const Vec3& direction, double radius_m) {
  std::vector<uint64_t> all;
  for (size_t i = 0; i < points.size(); ++i) all.push_back(i);
  Task task;
  return heights_along(cloud_of(surface), cloud_of(points), all, direction, radius_m, task);
}

}  // namespace

TEST_CASE("heights_along__are_those_over_a_curved_ground_up_to_its_curvature") {
  const auto bowl = [](double x, double y) { return 0.05 * (x * x + y * y) - 0.3 * x; };
  const auto ground = scattered_over(10, 4000, 1, bowl);
  RandomStream random(92, 0);
  const auto points =
      scattered_over(8, 300, 2, [&](double, double) { return 4 * random.uniform() - 2; });
  constexpr double kLongest = 1;
  const auto heights = heights_over(ground, points, {0, 0, 1}, kLongest);
  for (size_t i = 0; i < points.size(); ++i) {
    const double truth = points[i].z - bowl(points[i].x, points[i].y);
    // The chord of a triangle with edges up to 1 m lies over the bowl by 0.05 (1 m)^2 / 3 at most.
    REQUIRE(heights[i] <= truth + 2e-6);
    REQUIRE(heights[i] >= truth - 0.05 * kLongest * kLongest / 3);
  }
}

TEST_CASE("heights_along__hold_for_any_direction_over_a_plane_and_on_the_national_grid") {
  const auto slope = [](double x, double y) { return 0.25 * x - 0.5 * y; };
  const auto ground = scattered_over(6, 1500, 3, slope);
  const auto points = scattered_over(3, 100, 4, [](double x, double) { return 0.5 + 0.1 * x; });
  for (const Vec3& direction :
       {Vec3{0, 0, 1}, Vec3{0, 0, -1}, normalized({0.4, 0.3, 1}), normalized({-0.2, -0.3, 0.7})}) {
    const auto heights = heights_over(ground, points, direction, 1),
               far = heights_over(shifted(ground, kFar), shifted(points, kFar), direction, 1);
    // Along the direction to the plane 0.25 x - 0.5 y - z = 0.
    const Vec3 across{-0.25, 0.5, 1};
    for (size_t i = 0; i < points.size(); ++i) {
      REQUIRE(std::fabs(heights[i] - dot(across, points[i]) / dot(across, direction)) < 1e-5);
      REQUIRE(heights[i] == far[i]);
    }
  }
}

TEST_CASE("heights_along__end_where_the_surface_does_and_bridge_no_hole_wider_than_the_radius") {
  auto ground = scattered_over(6, 3000, 5, [](double, double) { return 1.0; });
  std::erase_if(ground, [](const Vec3& p) { return std::hypot(p.x, p.y) < 0.8; });
  const std::vector<Vec3> points{{0, 0, 3}, {2, 1, 3}, {0.7, 0, 0}, {3.5, 0, 3}, {50, 50, 3}};
  const auto narrow = heights_over(ground, points, {0, 0, 1}, 0.9),
             wide = heights_over(ground, points, {0, 0, 1}, 4);
  CHECK(std::isnan(narrow[0]));
  CHECK(narrow[1] == doctest::Approx(2).epsilon(1e-12));
  CHECK(wide[0] == doctest::Approx(2).epsilon(1e-12));
  CHECK(wide[2] == doctest::Approx(-1).epsilon(1e-12));
  for (const size_t outside : {3u, 4u}) {
    CHECK(std::isnan(narrow[outside]));
    CHECK(std::isnan(wide[outside]));
  }
  // One edge that is too long is enough, whichever it is.
  std::vector<Vec3> flat{{0, 0, 0}, {1, 0.4, 0}, {2, 0, 0}};
  for (int k = 0; k < 6; ++k) {
    CHECK(std::isnan(heights_over(flat, {{1, 0.2, 1}}, {0, 0, 1}, 1.9)[0]));
    CHECK(heights_over(flat, {{1, 0.2, 1}}, {0, 0, 1}, 2.1)[0] == doctest::Approx(1));
    std::swap(flat[0], flat[static_cast<size_t>(1 + k % 2)]);  // all six orders
  }
  CHECK(heights_over(ground, {}, {0, 0, 1}, 1).empty());
  CHECK(std::isnan(heights_over({{0, 0, 0}, {1, 0, 0}}, {{0.5, 0, 1}}, {0, 0, 1}, 4)[0]));
}
