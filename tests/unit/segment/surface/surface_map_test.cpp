// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/surface/surface_map.h"

#include <doctest/doctest.h>

#include <numbers>

#include "base/random.h"

using namespace jalon;

namespace {

// Points of a unit-axis cylinder along Z between two angles.
std::vector<Vec3> shell(const Cylinder& c, double from_rad, double to_rad) {
  std::vector<Vec3> out;
  for (int i = 0; i <= 400; ++i) {
    const double angle = from_rad + (to_rad - from_rad) * i / 400;
    out.push_back(c.point + Vec3{c.radius * std::cos(angle), c.radius * std::sin(angle), 0.01 * i});
  }
  return out;
}

}  // namespace

TEST_CASE("surface_map__plane__keeps_distances") {
  const Plane plane{normalized(Vec3{1, -2, 0.5}), 3};
  const SurfaceMap map = SurfaceMap::of_plane(plane, {1, 1, 1});
  const Vec3 a{1, 1, 1}, step = cross(plane.normal, Vec3{0.2, 0.3, 0.4});
  CHECK(norm(map(a)) < 1e-12);
  CHECK(norm(map(a + step) - map(a)) == doctest::Approx(norm(step)).scale(0));
  CHECK(norm(map(a + 5 * plane.normal) - map(a)) < 1e-12);
}

TEST_CASE("surface_map__cylinder__unrolled_without_a_tear_where_points_are") {
  const Cylinder c{{3, 4, 5}, {0, 0, 1}, 0.5};
  Task task;
  for (const double from : {-2.0, 0.5, 2.5}) {  // 200 degrees of it, wherever they begin
    const auto points = shell(c, from, from + 3.5);
    const SurfaceMap map = SurfaceMap::of_cylinder(c, points, task);
    for (size_t i = 1; i < points.size(); ++i) {
      const Vec2 d = map(points[i]) - map(points[i - 1]);
      CHECK(std::fabs(d.u) == doctest::Approx(0.5 * 3.5 / 400).scale(0));
      CHECK(d.v == doctest::Approx(0.01).scale(0));
    }
  }
}

TEST_CASE("surface_map__sphere__caps_have_their_true_area") {
  const Sphere sphere{{1, 2, 3}, 2};
  const Vec3 middle = normalized(Vec3{1, 1, -0.5});
  const std::vector<Vec3> seen{sphere.centre + 2 * middle};
  Task task;
  const SurfaceMap map = SurfaceMap::of_sphere(sphere, seen, task);
  CHECK(norm(map(seen[0])) < 1e-9);
  const auto e = across(middle);
  for (const double angle : {0.1, 1.0, 2.0, 3.0}) {
    const Vec3 rim = sphere.centre +
                     2 * (std::cos(angle) * middle + std::sin(angle) * (0.6 * e[0] + 0.8 * e[1]));
    const double reach = norm(map(rim));
    CHECK(std::numbers::pi * reach * reach ==
          doctest::Approx(2 * std::numbers::pi * 4 * (1 - std::cos(angle))));
  }
  const Vec2 far_side = map(sphere.centre - 2 * middle);
  CHECK(std::isfinite(far_side.u));
}
