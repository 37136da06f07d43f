// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// Synthetic scenes after Boulaassal 2010 (window surrounds, a plane, staggered strips, two patches),
// and the covariance of the parameters.
#include <doctest/doctest.h>

#include <Eigen/Dense>
#include <cmath>
#include <numbers>

#include "unit/segment/method_checks.h"
#include "unit/segment/scenes.h"
#include "unit/segment/surrounds.h"

using namespace jalon;
using namespace jalon::test;

namespace {

constexpr double kDegree = std::numbers::pi / 180;

}  // namespace

TEST_CASE(
    "S2 surrounds: tolerance 0.025 m without connectivity gives wall, surrounds and joinery") {
  for (uint64_t seed = 1; seed <= 3; ++seed) {
    const Scene scene = surrounds(seed);
    const Segmentation s =
        run(cloud_of(scene.points),
            ransac_params(
                "{\"distance_tolerance_m\": 0.025, \"connectivity\": false, \"normals\": \"none\", "
                "\"min_points\": 600}",
                seed));
    REQUIRE(s.segments.size() == 3);
    for (int face = 1; face <= 3; ++face) {
      const auto total =
          static_cast<size_t>(std::count(scene.faces.begin(), scene.faces.end(), face));
      CHECK(overlap(scene, s, face, static_cast<uint32_t>(face)) >= total * 999 / 1000);
    }
  }
}

TEST_CASE("S2 surrounds: connectivity gives one wall, 12 surrounds and 12 joineries") {
  const Scene scene = surrounds(5);
  const Segmentation s =
      run(cloud_of(scene.points), ransac_params("{\"gap_m\": 0.2, \"merge_gap_m\": 0.2}"));
  size_t counts[4] = {};
  for (const Segment& segment : s.segments)
    for (int face = 1; face <= 3; ++face)
      counts[face] += 2 * overlap(scene, s, face, segment.label) > segment.fit.n;
  MESSAGE("wall " << counts[1] << ", surrounds " << counts[2] << ", joinery " << counts[3]);
  CHECK(counts[1] == 1);
  CHECK(counts[2] == 12);
  CHECK(counts[3] == 12);
}

TEST_CASE("S6 normality: residuals of one plane are normal about it") {
  Scene scene;
  RandomStream random(6, 0);
  const size_t n = 100000;
  for (size_t i = 0; i < n; ++i)
    scene.points.push_back({10 * random.uniform(), 0.0025 * random.normal(), 8 * random.uniform()});
  const Segmentation s = run(cloud_of(scene.points), ransac_params());
  REQUIRE(s.segments.size() == 1);
  const PlaneFit& fit = s.segments[0].fit;
  CHECK(fit.n == n);
  double sum = 0, squares = 0;
  size_t within99 = 0, within997 = 0;
  for (const Vec3& p : scene.points) {
    const double d = fit.plane.distance(p);
    sum += d;
    squares += d * d;
    within99 += std::fabs(d) < 2.576 * 0.0025;
    within997 += std::fabs(d) < 3.035 * 0.0025;
  }
  const double count = static_cast<double>(n);
  MESSAGE("mean " << sum / count << " m, std " << std::sqrt(squares / count) << " m, sigma "
                  << fit.sigma << " m");
  CHECK(std::fabs(sum / count) <
        1e-6);  // points beyond 4 sigma are kept out of the fit, so not zero to rounding
  CHECK(std::fabs(fit.sigma - 0.0025) < 0.01 * 0.0025);
  CHECK(std::fabs(static_cast<double>(within99) / count - 0.990) < 0.002);
  CHECK(std::fabs(static_cast<double>(within997) / count - 0.9976) < 0.001);
}

TEST_CASE("S7 oblique trap: staggered strips come out one by one, none slanted") {
  takes_staggered_strips_one_by_one(
      [](const CloudPtr& cloud, uint64_t seed) { return run(cloud, ransac_params("{}", seed)); });
}

TEST_CASE("S8 two coplanar patches 1 m apart are two segments, 0.3 m apart one") {
  for (const double gap : {1.0, 0.3}) {
    Scene scene;
    RandomStream random(8, 0);
    scene.rectangle(1, {0, 0, 0}, {2, 0, 0}, {0, 0, 3}, 4000, 0.003, random);
    scene.rectangle(2, {2 + gap, 0, 0}, {2, 0, 0}, {0, 0, 3}, 4000, 0.003, random);
    const Segmentation s = run(cloud_of(scene.points), ransac_params());
    CHECK(s.segments.size() == (gap == 1.0 ? 2 : 1));
  }
}

TEST_CASE("the facade's planes are right to a tenth of a millimetre, in every seed") {
  const Scene scene = facade_scene(1500, 9);
  const CloudPtr cloud = cloud_of(scene.points);
  double wall_offset = 0, wall_angle = 0;
  for (uint64_t seed = 1; seed <= 5; ++seed) {
    CAPTURE(seed);
    const Segmentation s = run(cloud, ransac_params("{\"distance_tolerance_m\": 0.015}", seed));
    CHECK(s.segments.size() == 18);
    for (int face = 1; face <= 18; ++face) {
      size_t best = 0, total = 0;
      uint32_t label = 0;
      for (const Segment& segment : s.segments)
        if (overlap(scene, s, face, segment.label) > best) {
          best = overlap(scene, s, face, segment.label);
          label = segment.label;
        }
      for (const int f : scene.faces) total += f == face;
      CAPTURE(face);
      REQUIRE(label != 0);
      CHECK(static_cast<double>(best) >= 0.93 * static_cast<double>(total));
      if (face != 1) continue;
      const PlaneFit& fit = s.segments[label - 1].fit;
      wall_offset = std::max(wall_offset, std::fabs(fit.centroid.y));
      wall_angle =
          std::max(wall_angle, std::acos(std::min(1.0, std::fabs(fit.plane.normal.y))) / kDegree);
    }
  }
  MESSAGE("wall: " << wall_offset * 1e3 << " mm, " << wall_angle << " degrees");
  CHECK(wall_offset < 0.0001);
  CHECK(wall_angle < 0.003);
}

TEST_CASE("the 99 % ellipsoid of a plane's parameters covers the truth in 99 % of draws") {
  constexpr int kDraws = 400;
  constexpr double kQuantile3 = 11.345;  // chi-square, 3 degrees of freedom, 99 %
  const Vec3 normal = normalized({0.3, -0.9, 0.2});
  const Vec3 u = normalized(cross({0, 0, 1}, normal)), v = cross(normal, u);
  int covered = 0;
  for (int draw = 0; draw < kDraws; ++draw) {
    Scene scene;
    RandomStream random(1000, static_cast<uint64_t>(draw));
    for (int i = 0; i < 2000; ++i) {
      const double a = 4 * random.uniform() - 1, b = 3 * random.uniform();
      scene.points.push_back(Vec3{5, 7, 2} + a * u + b * v + 0.004 * random.normal() * normal);
    }
    const Segmentation s =
        run(cloud_of(scene.points), ransac_params("{}", static_cast<uint64_t>(draw)), 1);
    REQUIRE(s.segments.size() == 1);
    const PlaneFit& fit = s.segments[0].fit;
    const double sign = dot(fit.plane.normal, normal) < 0 ? -1 : 1;
    const Vec3 d = sign * fit.plane.normal - normal;
    const Eigen::Vector4d error(d.x, d.y, d.z,
                                sign * fit.plane.offset - dot(normal, Vec3{5, 7, 2}));
    const Eigen::Matrix4d covariance = Eigen::Map<const Eigen::Matrix4d>(fit.covariance.data());
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d> eigen(covariance);
    CHECK(std::fabs(eigen.eigenvalues()(0)) < 1e-9 * eigen.eigenvalues()(3));  // rank 3
    double distance = 0;
    for (int k = 1; k < 4; ++k) {
      const double along = eigen.eigenvectors().col(k).dot(error);
      distance += along * along / eigen.eigenvalues()(k);
    }
    covered += distance <= kQuantile3;
  }
  MESSAGE(covered << " of " << kDraws << " draws inside");
  CHECK(covered >= 388);  // 396 expected, standard deviation 2
}
