// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <algorithm>
#include <chrono>

#include "cloud/neighbourhoods.h"
#include "unit/cloud/clouds.h"

namespace jalon {
namespace {

using namespace test;

Cloud features(const std::vector<Vec3>& points, const char* which, double radius_m = 0,
               uint32_t k = 16) {
  FeaturesSettings set;
  set.which = which;
  set.radius_m = radius_m;
  set.k = k;
  Task task;
  return with_features(cloud_of(points), set, task);
}

double median(const Cloud& cloud, const char* name) {
  const auto values = cloud.fields.require(name).values<float>();
  std::vector<float> sorted(values.begin(), values.end());
  std::nth_element(sorted.begin(), sorted.begin() + static_cast<ptrdiff_t>(sorted.size() / 2),
                   sorted.end());
  return double{sorted[sorted.size() / 2]};
}

std::vector<Vec3> plane_points(size_t n, double size, double sigma) {
  RandomStream random(31, 0);
  std::vector<Vec3> points;
  for (size_t i = 0; i < n; ++i)
    points.push_back({size * random.uniform(), sigma * random.normal(), size * random.uniform()});
  return points;
}

TEST_CASE("features__density_of_a_random_plane__is_the_true_one") {
  const auto points = plane_points(20000, 10, 0);  // 200 points a square metre
  CHECK(median(features(points, "density", 0, 32), "density") == doctest::Approx(200).epsilon(0.1));
  CHECK(median(features(points, "density", 0.5), "density") == doctest::Approx(200).epsilon(0.05));
}

TEST_CASE("features__wall_line_and_ball__shape_by_demantke") {
  const Cloud wall = features(plane_points(10000, 10, 0.002), "all");
  CHECK(median(wall, "planarity") > 0.6);
  CHECK(median(wall, "sphericity") < 0.05);
  CHECK(median(wall, "verticality") > 0.95);
  CHECK(median(wall, "surface_variation") < 0.01);
  CHECK(median(wall, "roughness") ==
        doctest::Approx(0.002 * 0.6745).epsilon(0.2).scale(0));  // median of a normal distribution
  RandomStream random(32, 0);
  std::vector<Vec3> wire;
  for (int i = 0; i < 2000; ++i)
    wire.push_back({0.01 * i, 0.001 * random.normal(), 0.001 * random.normal()});
  CHECK(median(features(wire, "linearity"), "linearity") > 0.9);
  CHECK(median(features(random_points(5000, 1, 33), "sphericity"), "sphericity") > 0.4);
  // The three shares add up to one.
  for (size_t i = 0; i < 100; ++i)
    CHECK(wall.fields.require("linearity").number(i) + wall.fields.require("planarity").number(i) +
              wall.fields.require("sphericity").number(i) ==
          doctest::Approx(1));
}

TEST_CASE("features__curvatures_of_a_sphere_and_a_cylinder__are_known") {
  const Cloud ball = features(sphere(40000, 2), "mean_curvature gaussian_curvature");
  CHECK(median(ball, "mean_curvature") == doctest::Approx(0.5).epsilon(0.01).scale(0));
  CHECK(median(ball, "gaussian_curvature") == doctest::Approx(0.25).epsilon(0.02).scale(0));
  RandomStream random(34, 0);
  std::vector<Vec3> pipe;
  for (int i = 0; i < 40000; ++i) {
    const double a = 2 * std::numbers::pi * random.uniform();
    pipe.push_back({0.5 * std::cos(a), 0.5 * std::sin(a), 4 * random.uniform()});
  }
  const Cloud round = features(pipe, "mean_curvature, gaussian_curvature", 0.15);
  CHECK(median(round, "mean_curvature") == doctest::Approx(1).epsilon(0.02));
  CHECK(std::fabs(median(round, "gaussian_curvature")) < 0.02);
}

TEST_CASE("features__of_balls_of_thousands_of_points_are_those_of_the_surface_they_lie_on") {
  // A piece of a saddle about its middle: the quadric is the surface itself, whatever the ball.
  std::vector<Vec3> points{{0, 0, 0}};
  for (const Vec3& p : random_points(6000, 2, 36)) {
    const double x = p.x - 1, y = p.y - 1;
    if (x * x + y * y < 1) points.push_back({x, y, 0.3 * x * x - 0.2 * y * y});
  }
  const Cloud all = features(points, "all", 3);  // every ball holds them all
  const auto of = [&](const char* name) { return all.fields.require(name).number(0); };
  const auto n = static_cast<double>(points.size());
  REQUIRE(points.size() > 4000);
  CHECK(of("density") == doctest::Approx(n / (std::numbers::pi * 9)));
  CHECK(of("gaussian_curvature") == doctest::Approx(0.6 * -0.4).epsilon(0.02).scale(0));
  CHECK(of("mean_curvature") == doctest::Approx((0.6 - 0.4) / 2).epsilon(0.05).scale(0));
  // Of shapes and roughness by the points one by one.
  Moments moments, others;
  for (size_t i = 0; i < points.size(); ++i) {
    moments.add(points[i]);
    if (i > 0) others.add(points[i]);
  }
  PrincipalFrame frame;
  REQUIRE(principal_frame(moments, frame));
  const auto& e = frame.eigenvalues;
  CHECK(of("surface_variation") == doctest::Approx(e[0] / (e[0] + e[1] + e[2])).epsilon(1e-5));
  CHECK(of("sphericity") == doctest::Approx(std::sqrt(e[0] / e[2])).epsilon(1e-5));
  CHECK(of("verticality") == doctest::Approx(1 - std::fabs(frame.n.z)).scale(1).epsilon(1e-6));
  REQUIRE(principal_frame(others, frame));
  CHECK(of("roughness") ==
        doctest::Approx(std::fabs(dot(frame.n, points[0] - frame.centre))).epsilon(1e-4));
}

TEST_CASE("features__roughness_leaves_the_point_out") {
  // One point 10 cm above an exact plane: its own plane must not be pulled toward it.
  std::vector<Vec3> points;
  for (int y = 0; y < 11; ++y)
    for (int x = 0; x < 11; ++x) points.push_back({0.1 * x, 0.1 * y, x == 5 && y == 5 ? 0.1 : 0.0});
  const Cloud out = features(points, "roughness");
  CHECK(out.fields.require("roughness").number(60) == doctest::Approx(0.1).epsilon(1e-4).scale(0));
}

TEST_CASE("features__unknown_or_no_name__is_refused_and_degenerate_points_give_nan") {
  CHECK(status_of([] { features({{0, 0, 0}}, "density glow"); }) == Status::kInvalidArgument);
  CHECK(status_of([] { features({{0, 0, 0}}, " , "); }) == Status::kInvalidArgument);
  for (const auto& points : {std::vector<Vec3>{{1, 2, 3}}, std::vector<Vec3>(30, Vec3{1, 1, 1})}) {
    const Cloud out = features(points, "all");
    CHECK(out.fields.size() == 10);
    for (const auto& column : out.fields)
      if (column->info().type == ElementType::kUint8) CHECK(column->number(0) == 0);
      else CHECK(std::isnan(column->number(0)));
  }
}

TEST_CASE("features__threads_and_shift__the_same_bits") {
  const auto points = random_points(20000, 4, 35);
  FeaturesSettings set;
  set.which = "all";
  Task one(threads(1)), seven(threads(7));
  for (const double radius : {0.0, 0.2, 1.5}) {  // of the last some thousand points are in a ball
    set.radius_m = radius;
    const Cloud near = with_features(cloud_of(points), set, one);
    CHECK(same_bits(near, with_features(cloud_of(points), set, seven)));
    CHECK(same_fields(near, with_features(cloud_of(shifted(points, kFar)), set, one)));
  }
}

}  // namespace
}  // namespace jalon
