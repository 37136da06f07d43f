// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Feet on local surfaces, against planes and paraboloids whose nearest points are known or searched for.
#include "compare/distance/local_surface.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "base/random.h"

using namespace jalon;

namespace {

// A frame that leans: heights count along its third axis.
struct Frame {
  Vec3 u{0.8, 0, -0.6}, v{0, 1, 0}, n{0.6, 0, 0.8}, at{0.02, -0.03, 0.01};
  Vec3 point(double x, double y, double z) const { return at + u * x + v * y + n * z; }
};

double bowl(double x, double y) { return 0.4 * x * x - 0.3 * x * y + 0.25 * y * y; }

std::vector<Vec3> points_of(const Frame& frame, double half, uint64_t seed) {
  RandomStream random(seed, 0);
  std::vector<Vec3> points;
  for (int i = 0; i < 20; ++i) {
    const double x = half * (2 * random.uniform() - 1), y = half * (2 * random.uniform() - 1);
    points.push_back(frame.point(x, y, bowl(x, y)));
  }
  return points;
}

}  // namespace

TEST_CASE("local_surface__foot_on_a_plane_is_straight_below_and_within_reach") {
  const Frame frame;
  LocalSurface surface;
  surface.set_plane(frame.n, frame.at, 1);
  RandomStream random(2, 0);
  size_t within = 0;
  for (int i = 0; i < 500; ++i) {
    const double x = 3 * random.uniform() - 1.5, y = 3 * random.uniform() - 1.5;
    const double z = random.normal();
    const Vec3 below = frame.point(x, y, 0);
    Vec3 foot;
    const bool found = surface.foot_on_plane(frame.point(x, y, z), foot);
    REQUIRE(norm(foot - below) < 1e-14);
    if (std::abs(norm(below) - 1) > 1e-12) REQUIRE(found == (norm(below) < 1));
    within += found ? 1 : 0;
  }
  // Of the area of a disc in a square: 500 draws scatter by 11.
  CHECK(std::abs(static_cast<double>(within) - 500 * std::numbers::pi / 9) < 40);
}

TEST_CASE("local_surface__foot_on_a_quadric_is_where_no_other_point_of_it_is_nearer") {
  const Frame frame;
  LocalSurface surface;
  surface.set_plane(frame.n, frame.at, 2);
  REQUIRE(surface.set_quadric(points_of(frame, 0.5, 3)));
  RandomStream random(4, 0);
  for (int i = 0; i < 200; ++i) {
    const double x = random.uniform() - 0.5, y = random.uniform() - 0.5;
    // Within a third of the least radius of curvature, 1 m: one foot only.
    const Vec3 p = frame.point(x, y, bowl(x, y) + 0.3 * (2 * random.uniform() - 1));
    Vec3 foot;
    REQUIRE(surface.foot_on_quadric(p, foot));
    const Vec3 d = foot - frame.at;
    const double fx = dot(d, frame.u), fy = dot(d, frame.v);
    REQUIRE(std::abs(dot(d, frame.n) - bowl(fx, fy)) < 1e-12);
    const Vec3 normal =
        normalized(frame.n - frame.u * (0.8 * fx - 0.3 * fy) - frame.v * (0.5 * fy - 0.3 * fx));
    // Newton's steps double the digits: of 0.2 m at most less than 1e-6 m is left after four.
    REQUIRE(norm(cross(p - foot, normal)) < 1e-6);
    for (int k = 0; k < 16; ++k) {
      const double a = fx + 0.05 * std::cos(k * std::numbers::pi / 8),
                   b = fy + 0.05 * std::sin(k * std::numbers::pi / 8);
      REQUIRE(norm(p - frame.point(a, b, bowl(a, b))) > norm(p - foot));
    }
  }
  surface.set_plane(frame.n, frame.at, 0.1);
  Vec3 foot;
  CHECK_FALSE(surface.foot_on_quadric(frame.point(0.4, 0.4, 0), foot));
}

TEST_CASE("local_surface__triangles_give_the_plane_inside_their_hull_and_its_border_outside") {
  const Frame frame;
  std::vector<Vec3> corners;
  for (const double x : {-1.0, 0.0, 1.0})
    for (const double y : {-1.0, 0.0, 1.0}) corners.push_back(frame.point(x, y, 0) - frame.at);
  LocalSurface surface;
  surface.set_plane(frame.n, {0, 0, 0}, 1);
  REQUIRE(surface.set_triangles(corners));
  const auto place = [&](double x, double y, double z) { return frame.point(x, y, z) - frame.at; };
  Vec3 foot;
  REQUIRE(surface.foot_on_triangles(place(0.3, -0.2, 0.1), 1, foot));
  CHECK(norm(foot - place(0.3, -0.2, 0)) < 1e-14);
  REQUIRE(surface.foot_on_triangles(place(1.25, 0.25, 0), 1.5, foot));
  CHECK(norm(foot - place(1, 0.25, 0)) < 1e-14);
}

TEST_CASE("local_surface__of_points_that_fix_none_is_refused") {
  const Frame frame;
  LocalSurface surface;
  std::vector<Vec3> line, circle;
  for (int i = 0; i < 12; ++i) {
    line.push_back({0.25 * i, 0, 0});
    const double a = i * std::numbers::pi / 6;
    circle.push_back(frame.point(std::cos(a), std::sin(a), 0));
  }
  surface.set_plane({0, 0, 1}, {0, 0, 0},
                    1);  // along the axes: the line stays one on the triangles' grid
  CHECK_FALSE(surface.set_triangles(line));
  CHECK_FALSE(surface.set_quadric(line));
  surface.set_plane(frame.n, frame.at, 1);
  CHECK_FALSE(surface.set_quadric(circle));  // x^2 + y^2 and 1 are the same on it
  CHECK(surface.set_triangles(circle));
  auto five = points_of(frame, 0.5, 5);
  five.resize(5);
  CHECK_FALSE(surface.set_quadric(five));
}
