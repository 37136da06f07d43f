// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <algorithm>
#include <chrono>

#include "unit/cloud/clouds.h"

namespace jalon {
namespace {

using namespace test;

Vec3 normal_at(const Cloud& cloud, size_t i) {
  const auto n = cloud.fields.require("normal").values<float>();
  return {double{n[3 * i]}, double{n[3 * i + 1]}, double{n[3 * i + 2]}};
}

NormalsSettings normal_options(const char* method, const char* orientation = "none") {
  return settings_by<NormalsSettings>(normals_rows(),
                                      {{"method", method}, {"orientation", orientation}});
}

TEST_CASE("normals__curvature_is_kept_only_when_asked_for") {
  const Cloud cloud = cloud_of(sphere(500));
  NormalsSettings set = normal_options("pca");
  Task task;
  const Cloud plain = with_normals(cloud, set, task);
  CHECK(plain.fields.size() == 1);
  set.curvature = true;
  for (const double radius_m : {0.0, 0.3}) {
    set.radius_m = radius_m;
    const Cloud both = with_normals(cloud, set, task);
    CHECK(both.fields.size() == 2);
    for (const float v : both.fields.require("curvature").values<float>())
      REQUIRE((v > 0 && v < 0.1f));  // of a ball
  }
}

/// Points of a sphere of radius 1 with noise of this share of the spacing, along the normal.
std::vector<Vec3> noisy_sphere(size_t n, double share) {
  auto points = sphere(n);
  const double sigma = share * std::sqrt(4 * std::numbers::pi / static_cast<double>(n));
  RandomStream random(21, 0);
  for (Vec3& p : points) p *= 1 + sigma * random.normal();
  return points;
}

struct Quality {
  double median_deg, seconds;
};
Quality measure(const std::vector<Vec3>& points, const char* method) {
  const Cloud cloud = cloud_of(points);
  Task warm;
  cloud.octree(warm);
  const NormalsSettings set = normal_options(method);
  Cloud out;
  double best = 1e9;
  for (int run = 0; run < 3; ++run) {
    Task task;
    const auto start = std::chrono::steady_clock::now();
    out = with_normals(cloud, set, task);
    best = std::min(
        best, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
  std::vector<double> angles;
  for (size_t i = 0; i < points.size(); ++i) {
    const Vec3 n = normal_at(out, i), truth = normalized(points[i]);
    angles.push_back(std::atan2(norm(cross(n, truth)), std::fabs(dot(n, truth))) * 180 /
                     std::numbers::pi);
  }
  std::nth_element(angles.begin(), angles.begin() + static_cast<ptrdiff_t>(angles.size() / 2),
                   angles.end());
  return {angles[angles.size() / 2], best};
}

TEST_CASE("normals__sphere_with_noise_of_5_percent_of_the_spacing__9_11_with_figures") {
  const auto points = noisy_sphere(200000, 0.05);
  const Quality pca = measure(points, "pca"), quadric = measure(points, "quadric"),
                triangulation = measure(points, "triangulation");
  MESSAGE("median angle error (deg): pca ", pca.median_deg, ", quadric ", quadric.median_deg,
          ", triangulation ", triangulation.median_deg);
  MESSAGE("seconds for 200 000 points, index built: pca ", pca.seconds, ", quadric ",
          quadric.seconds, ", triangulation ", triangulation.seconds,
          "; method 1 / method 2 = ", pca.seconds / triangulation.seconds);
  CHECK(pca.median_deg < triangulation.median_deg);
  CHECK(pca.median_deg < 10);
  CHECK(triangulation.median_deg < 10);
  CHECK(quadric.median_deg < 10);
}

TEST_CASE("normals__exact_plane__every_method_gives_its_normal") {
  const Vec3 truth = normalized({0.3, -0.4, 0.8});
  const Vec3 u = normalized(cross(truth, {0, 0, 1})), v = cross(truth, u);
  RandomStream random(22, 0);
  std::vector<Vec3> points;
  for (int i = 0; i < 5000; ++i) {
    const double a = 10 * random.uniform(), b = 10 * random.uniform();
    points.push_back(u * a + v * b);
  }
  Task task;
  for (const char* method : {"pca", "quadric", "triangulation"}) {
    const Cloud out = with_normals(cloud_of(points), normal_options(method), task);
    double worst = 0;
    for (size_t i = 0; i < points.size(); ++i)
      worst = std::max(worst, norm(cross(normal_at(out, i), truth)));
    CAPTURE(method);
    CHECK(worst < 1e-5);
  }
}

TEST_CASE("normals__quadric_on_a_curved_surface__is_closer_than_the_plane_near_a_border") {
  // A paraboloid without noise: at its border the neighbours lie to one side, which tilts a plane
  // but no quadric.
  RandomStream random(23, 0);
  std::vector<Vec3> points;
  for (int i = 0; i < 5000; ++i) {
    const double x = random.uniform(), y = random.uniform();
    points.push_back({x, y, 0.5 * x * x + 0.3 * x * y});
  }
  const auto mean_error = [&](const char* method) {
    Task task;
    const Cloud out = with_normals(cloud_of(points), normal_options(method), task);
    double sum = 0;
    for (size_t i = 0; i < points.size(); ++i) {
      const Vec3 truth = normalized({-(points[i].x + 0.3 * points[i].y), -0.3 * points[i].x, 1});
      sum += norm(cross(normal_at(out, i), truth));
    }
    return sum / static_cast<double>(points.size());
  };
  const double plane = mean_error("pca"), quadric = mean_error("quadric");
  MESSAGE("mean angle error (rad): pca ", plane, ", quadric ", quadric);
  CHECK(quadric < 0.1 * plane);
  CHECK(quadric < 1e-4);
}

TEST_CASE("normals__centroid_orientation_on_a_convex_solid__all_outward_9_12") {
  // An ellipsoid and a box, on the national grid.
  std::vector<Vec3> ellipsoid = sphere(20000), box;
  for (Vec3& p : ellipsoid) p = {3 * p.x, 2 * p.y, p.z};
  RandomStream random(24, 0);
  for (int i = 0; i < 20000; ++i) {
    Vec3 p{random.uniform(), random.uniform(), random.uniform()};
    p[i % 3] = i % 2;
    box.push_back(p);
  }
  Task task;
  for (const auto& solid : {ellipsoid, box})
    for (const char* method : {"pca", "quadric", "triangulation"}) {
      const Vec3 centre = solid == box ? Vec3{0.5, 0.5, 0.5} : Vec3{};
      NormalsSettings set = normal_options(method, "centroid");
      const Cloud out = with_normals(cloud_of(shifted(solid, kFar)), set, task);
      size_t inward = 0;
      for (size_t i = 0; i < solid.size(); ++i)
        inward += dot(normal_at(out, i), solid[i] - centre) < 0;
      CAPTURE(method);
      CHECK(inward == 0);
      set.outward = false;
      const Cloud turned = with_normals(cloud_of(shifted(solid, kFar)), set, task);
      for (size_t i = 0; i < solid.size(); i += 97)
        CHECK(norm(normal_at(out, i) + normal_at(turned, i)) < 1e-6);
    }
}

TEST_CASE("normals__station_orientation__faces_each_point_s_own_station") {
  // A wall between two stations: the halves of the cloud were seen from opposite sides.
  auto points = random_points(4000, 5, 25);
  for (Vec3& p : points) p.y = 0;
  Cloud cloud = cloud_of(points);
  Transform front, back;
  front.m[7] = -10;
  back.m[7] = 10;
  cloud.stations = {{"front", true, front, 0, 2000}, {"back", true, back, 2000, 2000}};
  Task task;
  const Cloud out = with_normals(cloud, normal_options("pca", "station"), task);
  for (size_t i = 0; i < points.size(); ++i)
    CHECK(normal_at(out, i).y * (i < 2000 ? -1 : 1) > 0.99);
  cloud.stations[1].has_pose = false;
  CHECK(status_of([&] { with_normals(cloud, normal_options("pca", "station"), task); }) ==
        Status::kInvalidArgument);
  cloud.stations.clear();
  CHECK(status_of([&] { with_normals(cloud, normal_options("pca", "station"), task); }) ==
        Status::kInvalidArgument);
  NormalsSettings set = normal_options("pca", "point");
  set.viewpoint = {0, -3, 0};
  const Cloud seen = with_normals(cloud, set, task);
  for (size_t i = 0; i < points.size(); i += 7) CHECK(normal_at(seen, i).y < -0.99);
  set.viewpoint = {0, -3};
  CHECK(status_of([&] { with_normals(cloud, set, task); }) == Status::kInvalidArgument);
}

TEST_CASE("normals__inverted_twice__are_the_same_bits_and_none_is_an_error") {
  Task task;
  const Cloud cloud = with_normals(cloud_of(noisy_sphere(2000, 0.05)), normal_options("pca"), task);
  const Cloud once = with_inverted_normals(cloud, task);
  CHECK(norm(normal_at(cloud, 5) + normal_at(once, 5)) == 0);
  CHECK(same_bits(with_inverted_normals(once, task), cloud));
  CHECK(status_of([&] {
          with_inverted_normals(cloud_of({{0, 0, 0}}), task);
        }) == Status::kNotFound);
}

TEST_CASE("normals__too_few_equal_or_collinear_points__nan") {
  std::vector<Vec3> line;
  for (int i = 0; i < 100; ++i) line.push_back({0.5 * i, 0.25 * i, 0.125 * i});
  const std::vector<std::vector<Vec3>> cases{
      {{1, 2, 3}}, {{1, 2, 3}, {4, 5, 6}}, std::vector<Vec3>(50, Vec3{1, 2, 3}), line};
  Task task;
  for (const auto& points : cases)
    for (const char* method : {"pca", "quadric", "triangulation"}) {
      CAPTURE(method);
      CAPTURE(points.size());
      const Cloud out = with_normals(cloud_of(points), normal_options(method), task);
      for (size_t i = 0; i < points.size(); ++i) CHECK(std::isnan(normal_at(out, i).x));
    }
}

TEST_CASE("normals__threads_and_shift__the_same_bits") {
  auto points = noisy_sphere(20000, 0.05);
  for (Vec3& p : points) p = {snapped(5 * p.x), snapped(5 * p.y), snapped(5 * p.z)};
  Task one(threads(1)), two(threads(2)), seven(threads(7));
  for (const char* method : {"pca", "quadric", "triangulation"})
    for (const char* orientation : {"none", "centroid"}) {
      CAPTURE(method);
      const NormalsSettings set = normal_options(method, orientation);
      const Cloud near = with_normals(cloud_of(points), set, one);
      CHECK(same_bits(near, with_normals(cloud_of(points), set, two)));
      CHECK(same_bits(near, with_normals(cloud_of(points), set, seven)));
      CHECK(same_fields(near, with_normals(cloud_of(shifted(points, kFar)), set, one)));
    }
}

TEST_CASE("normals__by_radius__equal_those_by_k_where_the_ball_holds_k") {
  // A square grid: a ball of 1.1 spacings holds 5 points, the four direct neighbours and the point itself.
  std::vector<Vec3> points;
  for (int y = 0; y < 30; ++y)
    for (int x = 0; x < 30; ++x)
      points.push_back({double(x), double(y), 0.25 * ((x * 7 + y * 3) % 5)});
  NormalsSettings by_radius = normal_options("quadric");
  by_radius.radius_m = 3.0;
  Task task;
  const Cloud out = with_normals(cloud_of(points), by_radius, task);
  for (size_t i = 0; i < points.size(); ++i)
    CHECK(norm(normal_at(out, i)) == doctest::Approx(1).epsilon(1e-5));
}

}  // namespace
}  // namespace jalon
