// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/plane.h"

#include <doctest/doctest.h>

#include <vector>

#include "base/random.h"

using namespace jalon;

namespace {

std::vector<Vec3> noisy_plane(size_t n, const Vec3& origin, double sigma_m, RandomStream& random) {
  const Vec3 normal = normalized(Vec3{1, 2, 2}), u = normalized(Vec3{2, -1, 0}),
             v = cross(normal, u);
  std::vector<Vec3> out;
  for (size_t i = 0; i < n; ++i) {
    const double a = 4 * random.uniform(), b = 2 * random.uniform();
    out.push_back(origin + a * u + b * v + sigma_m * random.normal() * normal);
  }
  return out;
}

}  // namespace

TEST_CASE("fit_plane__least_squares__no_plane_nearby_has_a_smaller_rms") {
  RandomStream random(2, 3);
  const auto points = noisy_plane(200, {10, 20, 30}, 0.01, random);
  PlaneFit fit;
  REQUIRE(fit_plane(points, fit));
  const auto squares = [&](const Plane& plane) {
    double sum = 0;
    for (const Vec3& p : points) sum += plane.distance(p) * plane.distance(p);
    return sum;
  };
  const double least = squares(fit.plane);
  CHECK(fit.sigma == doctest::Approx(std::sqrt(least / 197)).scale(0));
  CHECK(fit.eigenvalues[0] == doctest::Approx(least / 200).scale(0));
  for (const Vec3& turn : {fit.axis_u, fit.axis_v, -fit.axis_u, -fit.axis_v}) {
    Plane other;
    other.normal = normalized(fit.plane.normal + 1e-4 * turn);
    other.offset = dot(other.normal, fit.centroid);
    CHECK(squares(other) > least);
  }
  CHECK(norm(cross(fit.axis_u, fit.axis_v) - fit.plane.normal) < 1e-12);
  Moments moments;
  moments.reference = points[0];
  for (const Vec3& p : points) moments.add(p);
  const Plane other{normalized(Vec3{1, 1, 1}), 33};
  CHECK(rms_about(moments, other) == doctest::Approx(std::sqrt(squares(other) / 200)).scale(0));
}

TEST_CASE("fit_plane__covariance_is_the_scatter_of_many_fits") {
  RandomStream random(5, 1);
  constexpr int kDraws = 1500;
  double told = 0, seen = 0;
  for (int i = 0; i < kDraws; ++i) {
    PlaneFit fit;
    REQUIRE(fit_plane(noisy_plane(30, {0, 0, 0}, 0.01, random), fit));
    const double sign = fit.plane.normal.x < 0 ? -1 : 1;
    const double error = sign * fit.plane.offset;  // the true plane goes through the origin
    told += fit.covariance[15] / kDraws;
    seen += error * error / kDraws;
  }
  CHECK(seen == doctest::Approx(told).epsilon(0.15).scale(0));
}

TEST_CASE("fit_plane__three_points_exact_and_fewer_or_collinear_refused") {
  PlaneFit fit;
  REQUIRE(fit_plane(std::vector<Vec3>{{0, 0, 1}, {1, 0, 1}, {0, 1, 1}}, fit));
  CHECK(std::fabs(fit.plane.normal.z) == doctest::Approx(1));
  CHECK(fit.sigma == 0);
  CHECK_FALSE(fit_plane(std::vector<Vec3>{}, fit));
  CHECK_FALSE(fit_plane(std::vector<Vec3>{{0, 0, 0}, {1, 2, 3}}, fit));
  CHECK_FALSE(fit_plane(std::vector<Vec3>{{0, 0, 0}, {1, 2, 3}, {2, 4, 6}, {3, 6, 9}}, fit));
  CHECK_FALSE(fit_plane(std::vector<Vec3>(9, Vec3{652000, 6861000, 30}), fit));
  Plane plane;
  REQUIRE(plane_through({0, 0, 2}, {5, 0, 2}, {0, 3, 2}, plane));
  CHECK(plane.normal == Vec3{0, 0, 1});
  CHECK(plane.offset == 2);
  CHECK_FALSE(plane_through({0, 0, 0}, {1, 0, 0}, {2, 1e-4, 0}, plane));
}

TEST_CASE("shift_origin__gives_what_a_fit_of_shifted_points_gives") {
  RandomStream random(7, 3);
  auto points = noisy_plane(50, {1, 2, 3}, 0.005, random);
  PlaneFit fit, there;
  REQUIRE(fit_plane(points, fit));
  const Vec3 shift{300, -200, 50};
  for (Vec3& p : points) p += shift;
  REQUIRE(fit_plane(points, there));
  const double near = fit.covariance[15];
  shift_origin(fit, shift);
  CHECK(norm(fit.centroid - there.centroid) < 1e-9);
  const double sign = dot(fit.plane.normal, there.plane.normal) < 0 ? -1 : 1;
  CHECK(fit.plane.offset == doctest::Approx(sign * there.plane.offset));
  CHECK(fit.covariance[15] == doctest::Approx(there.covariance[15]).epsilon(1e-6).scale(0));
  CHECK(fit.covariance[15] > 100 * near);  // the offset far away is worth less
}

TEST_CASE("moments__of_parts_add_up_and_turn_over_keeps_the_plane") {
  RandomStream random(9, 3);
  const auto points = noisy_plane(40, {0, 0, 0}, 0.1, random);
  Moments all, a, b;
  for (size_t i = 0; i < points.size(); ++i) {
    const Vec3& p = points[i];
    all.add(p);
    (i < 17 ? a : b).add(p);
  }
  a += b;
  for (size_t k = 0; k < 6; ++k)
    CHECK(a.covariance()[k] == doctest::Approx(all.covariance()[k]).epsilon(1e-9).scale(0));
  PlaneFit fit;
  REQUIRE(fit_plane(points, fit));
  PlaneFit turned = fit;
  turn_over(turned);
  CHECK(turned.axis_u == fit.axis_u);
  CHECK(norm(cross(turned.axis_u, turned.axis_v) - turned.plane.normal) < 1e-12);
  for (const Vec3& p : points)
    CHECK(turned.plane.distance(p) == doctest::Approx(-fit.plane.distance(p)));
}
