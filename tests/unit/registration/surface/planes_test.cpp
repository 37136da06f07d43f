// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Local planes against the faces that the points were drawn on; columns are in patches_test.cpp.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "registration/surface/planes.h"
#include "unit/registration/icp_problems.h"

using namespace jalon;
using namespace jalon::test;

namespace {

constexpr double kPlanesNoise_m = 0.003;

struct Surface {
  Cloud cloud;
  SurfacePlanes planes;

  explicit Surface(const std::vector<Vec3>& points, uint32_t k = 16) : cloud(cloud_of(points)) {
    Task task;
    planes = surface_planes(cloud.octree(task), k, task);
  }
};

std::vector<Vec3> level_sheet(int n, double noise_m = kPlanesNoise_m) {
  RandomStream random(111, 0);
  return noisy_sheet({0.05, 0, 0}, {0.1, 0, 0}, {0, 0.1, 0}, n, n, noise_m, random);
}

}  // namespace

TEST_CASE("surface_planes__tell_noise_height_and_tilt_of_a_sheet_as_they_are") {
  const Surface sheet(level_sheet(40));
  const SurfacePlanes& s = sheet.planes;
  double turned2 = 0, stated2 = 0, off2 = 0;
  for (size_t i = 0; i < s.size(); ++i) {
    const SurfacePlane& plane = s.planes[i];
    const Vec3 n = plane.unit();
    turned2 += (n.x * n.x + n.y * n.y) / 2;
    stated2 += double{plane.tilt_rad} * double{plane.tilt_rad};
    const double z = s.tree->cube().origin.z + s.place(i).z;
    off2 += std::pow(z + n.z * double{plane.height_m}, 2);
  }
  const auto n = static_cast<double>(s.size());
  // The median scatter of 13 degrees of freedom is 0.975 sigma; 1600 points of 16 have it to 3 %.
  CHECK(s.noise_m == doctest::Approx(0.975 * kPlanesNoise_m).scale(0).epsilon(0.06));
  // A hundred planes share no points: a mean square of two turns each is good to a tenth.
  CHECK(turned2 / stated2 == doctest::Approx(1).scale(0).epsilon(0.2));
  CHECK(std::sqrt(off2 / n) < 0.4 * kPlanesNoise_m);  // 1 / sqrt(16), more along the border
  CHECK(s.radius_m > 0.1);                            // 16 points of a grid of 0.1 m: 0.16
  CHECK(s.radius_m < 0.25);
}

TEST_CASE("surface_planes__beside_an_edge_are_those_of_the_points_own_face") {
  std::vector<Vec3> points = level_sheet(20);
  const size_t of_floor = points.size();
  RandomStream random(112, 0);
  const auto wall =
      noisy_sheet({0, 0, 0.05}, {0, 0.1, 0}, {0, 0, 0.1}, 20, 20, kPlanesNoise_m, random);
  points.insert(points.end(), wall.begin(), wall.end());
  const Surface edge(points);
  const SurfacePlanes& s = edge.planes;
  size_t near = 0, flat = 0, right = 0, faces = 0;
  for (size_t i = 0; i < s.size(); ++i) {
    const uint32_t index = s.tree->order()[i];
    const bool on_floor = index < of_floor;
    if ((on_floor ? points[index].x : points[index].z) > 0.2) continue;
    ++near;
    if (!s.flat(i)) continue;
    ++flat;
    faces += s.planes[i].shape == SurfaceShape::kFace;
    const Vec3 n = s.planes[i].unit();
    right += std::abs(on_floor ? n.z : n.x) > 0.99;  // 8 degrees; around the corner it is 90
  }
  CHECK(near >= 60);
  CHECK(faces > near / 4);
  CHECK(static_cast<double>(right) >= 0.9 * static_cast<double>(flat));
  CHECK(static_cast<double>(flat) >= 0.8 * static_cast<double>(near));
}

TEST_CASE("surface_planes__are_none_where_points_span_no_plane") {
  std::vector<Vec3> line;
  for (int i = 0; i < 40; ++i) line.push_back({0.25 * i, 0.5 * i, 0});
  const Surface thin(line), three(std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  for (const SurfacePlanes* s : {&thin.planes, &three.planes}) {
    for (size_t i = 0; i < s->size(); ++i) {
      CHECK(std::isinf(s->planes[i].sigma_m));
      CHECK_FALSE(s->flat(i));
    }
    CHECK(s->radius_m == 0);
  }
}

TEST_CASE("flattest_points__are_the_flattest_of_each_cell_and_axis") {
  std::vector<Vec3> points = random_points(1500, 2, 5);
  RandomStream random(113, 0);
  for (size_t i = 0; i < points.size(); ++i)  // three sides
    points[i][static_cast<int>(i % 3)] = kPlanesNoise_m * random.normal();
  const Surface corner(points, 8);
  const SurfacePlanes& s = corner.planes;
  Task task;
  const int level = 3;
  const auto found = flattest_points(s, level, task);
  const auto axis_at = [&](size_t i) {
    const Vec3 n = s.planes[i].unit();
    const double most = std::max({std::abs(n.x), std::abs(n.y), std::abs(n.z)});
    return std::abs(n.x) == most ? 0 : std::abs(n.y) == most ? 1 : 2;
  };
  std::vector<uint32_t> expected;
  for (uint32_t i = 0; i < s.size(); ++i) {
    bool is_flattest = s.flat(i);
    for (uint32_t k = 0; k < s.size() && is_flattest; ++k) {
      const bool rivals =
          s.flat(k) && axis_at(k) == axis_at(i) &&
          s.tree->code(k) >> 3 * (21 - level) == s.tree->code(i) >> 3 * (21 - level);
      const float own = s.planes[i].sigma_m, other = s.planes[k].sigma_m;
      is_flattest = !rivals || own < other || (own == other && i <= k);
    }
    if (is_flattest) expected.push_back(i);
  }
  CHECK(found == expected);
  CHECK(found.size() > 20);
}
