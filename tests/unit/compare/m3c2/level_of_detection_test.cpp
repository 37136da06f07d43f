// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/m3c2/level_of_detection.h"

#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <cstdlib>
#include <doctest/doctest.h>
#include <string>

#include "base/random.h"
#include "compare/m3c2/m3c2.h"
#include "compare/m3c2/point_covariances.h"

using namespace jalon;

namespace {

constexpr double kNoise = 0.003;  // m

CloudPtr level_of_detection_cloud_of(const std::vector<double>& xyz,
                                     const std::vector<double>& covariances = {}) {
  Buffer<double> buffer(xyz.size());
  std::copy(xyz.begin(), xyz.end(), buffer.data());
  Cloud cloud = make_cloud(std::move(buffer));
  if (!covariances.empty())
    cloud.fields.set(make_column<double>({"covariance", ElementType::kFloat64, 6, "m2", ""},
                                         std::span(covariances)));
  return std::make_shared<const Cloud>(std::move(cloud));
}

/// Discs of 0.15 m, one at each whole x and y, with so many points each: cylinders that do not overlap.
struct Discs {
  std::vector<double> xyz, covariances;
};
template <class Noise>
Discs discs(size_t side, size_t points, uint64_t stream, Noise noise) {
  RandomStream random(95, stream);
  Discs out;
  for (size_t d = 0; d < side * side; ++d)
    for (size_t i = 0; i < points; ++i) {
      const double r = 0.1499 * std::sqrt(random.uniform()),
                   a = 6.283185307179586 * random.uniform();
      double variance = kNoise * kNoise;
      const double z = noise(random, variance);
      for (const double c : {static_cast<double>(d % side) + r * std::cos(a),
                             static_cast<double>(d / side) + r * std::sin(a), z})
        out.xyz.push_back(c);
      for (const double c : {1e-6, 0.0, 0.0, 1e-6, 0.0, variance}) out.covariances.push_back(c);
    }
  return out;
}

/// Share of the centres where |distance| <= lod, of those compared.
double share_within(const CloudPtr& reference, const CloudPtr& compared, size_t side,
                    const M3c2Settings& settings) {
  std::vector<double> centres;
  for (size_t d = 0; d < side * side; ++d)
    for (const double c : {static_cast<double>(d % side), static_cast<double>(d / side), 0.0})
      centres.push_back(c);
  Task task;
  const Comparison made =
      compare_m3c2_core(reference, compared, level_of_detection_cloud_of(centres), settings, task);
  REQUIRE(made.summary.require("compared").number(0) == static_cast<double>(side * side));
  return 1 - made.summary.require("significant").number(0) / static_cast<double>(side * side);
}

using Position = M3c2Settings::Position;
std::string name_of(Position position) { return position == Position::kMedian ? "median" : "mean"; }

M3c2Settings vertical(Position position) {
  M3c2Settings settings;
  settings.normals = M3c2Settings::Normals::kVertical;
  settings.position = position;
  return settings;
}

double normal_noise(RandomStream& random, double&) { return kNoise * random.normal(); }

}  // namespace

TEST_CASE("lod__false_alarms_are_five_percent_where_nothing_moved") {
  const size_t side = 60;  // 3600 cylinders: the share is known to 0.4 %
  for (const size_t n : {10, 11, 15, 20, 30, 60}) {
    for (const Position position : {Position::kMedian, Position::kMean}) {
      const auto a = level_of_detection_cloud_of(discs(side, n, 2 * n, normal_noise).xyz);
      const auto b = level_of_detection_cloud_of(discs(side, n, 2 * n + 1, normal_noise).xyz);
      const double share = share_within(a, b, side, vertical(position));
      MESSAGE("FIGURE " << name_of(position) << " of " << n << " + " << n
                        << " points: " << 100 * share << " % within the level of detection");
      CHECK(share >= 0.93);
      CHECK(share <= 0.97);
    }
  }
}

TEST_CASE("lod__holds_for_unequal_samples_rough_noise_and_slopes") {
  const size_t side = 50;
  const auto check = [&](const char* what, const Discs& a, const Discs& b) {
    for (const Position position : {Position::kMedian, Position::kMean}) {
      const double share =
          share_within(level_of_detection_cloud_of(a.xyz), level_of_detection_cloud_of(b.xyz), side,
                       vertical(position));
      MESSAGE("FIGURE " << std::string(what) << ", " << name_of(position) << ": " << 100 * share
                        << " %");
      CHECK(share >= 0.93);
      CHECK(share <= 0.98);
    }
  };
  check("10 and 40 points", discs(side, 10, 100, normal_noise), discs(side, 40, 101, normal_noise));
  check("3 and 9 mm noise, 20 points", discs(side, 20, 102, normal_noise),
        discs(side, 20, 103,
              [](RandomStream& random, double&) { return 3 * kNoise * random.normal(); }));
  const auto rough = [](RandomStream& random, double&) { return 0.03 * random.normal(); };
  check("30 mm noise, 12 points", discs(side, 12, 104, rough), discs(side, 12, 105, rough));
  const auto even = [](RandomStream& random, double&) { return 0.02 * (random.uniform() - 0.5); };
  check("even over 20 mm, as on a slope, 20 points", discs(side, 20, 106, even),
        discs(side, 20, 107, even));
}

TEST_CASE("lod__normals_from_the_points_keep_the_false_alarms") {
  // A wide plane on a slope, cylinders 0.31 m apart, normals from the reference: 25 to 35 points a cylinder.
  const auto slope = [](uint64_t stream) {
    RandomStream random(96, stream);
    std::vector<double> xyz;
    for (size_t i = 0; i < 90000; ++i) {
      const double x = 15 * random.uniform(), y = 15 * random.uniform();
      for (const double c : {x, y, 0.3 * x - 0.2 * y + 0.0032 * random.normal()}) xyz.push_back(c);
    }
    return level_of_detection_cloud_of(xyz);
  };
  std::vector<double> centres;
  for (double x = 0.5; x < 14.5; x += 0.33)
    for (double y = 0.5; y < 14.5; y += 0.33)
      for (const double c : {x, y, 0.3 * x - 0.2 * y}) centres.push_back(c);
  for (const Position position : {Position::kMedian, Position::kMean}) {
    M3c2Settings settings;
    settings.position = position;
    Task task;
    const Comparison made =
        compare_m3c2_core(slope(1), slope(2), level_of_detection_cloud_of(centres), settings, task);
    const double n = made.summary.require("compared").number(0);
    const double share = 1 - made.summary.require("significant").number(0) / n;
    MESSAGE("FIGURE " << name_of(position) << ", normals at scale: " << 100 * share << " % of " << n
                      << " cylinders within the level of detection");
    CHECK(n >= 1000);
    CHECK(share >= 0.93);
    CHECK(share <= 0.97);
  }
}

TEST_CASE("lod__covariance_of_the_registration_covers_the_moves_it_allows") {
  // Each of 400 moves is drawn from the covariance; the level at points around must hold it in 95 %.
  std::vector<double> covariance(36, 0.0);
  const double sigma[] = {2e-4, 3e-4, 1e-4, 0.001, 0.002, 0.0015};
  for (size_t i = 0; i < 6; ++i) covariance[7 * i] = sigma[i] * sigma[i];
  covariance[3] = covariance[18] =
      0.5 * sigma[0] * sigma[3];  // a turn about x goes with a shift along x
  const Vec3 centre{5, -3, 2};
  const RigidUncertainty rigid(covariance, centre);
  RandomStream random(97, 0);
  size_t within = 0, count = 0;
  for (size_t k = 0; k < 20000; ++k) {
    double move[6];
    for (size_t i = 0; i < 6; ++i) move[i] = sigma[i] * random.normal();
    move[3] = sigma[3] * (0.5 * move[0] / sigma[0] + std::sqrt(0.75) * random.normal());
    const Vec3 place{20 * random.uniform(), 20 * random.uniform(), 20 * random.uniform()};
    const Vec3 normal = normalized({random.normal(), random.normal(), random.normal()});
    const Vec3 moved =
        cross(Vec3{move[0], move[1], move[2]}, place - centre) + Vec3{move[3], move[4], move[5]};
    within +=
        std::fabs(dot(moved, normal)) <= 1.959964 * std::sqrt(rigid.variance_along(place, normal));
    ++count;
  }
  const double share = static_cast<double>(within) / static_cast<double>(count);
  MESSAGE("FIGURE registration covariance: " << 100 * share << " % of the moves within 1.96 sigma");
  CHECK(std::fabs(share - 0.95) < 0.006);
}

TEST_CASE("lod__point_covariances_are_propagated") {
  const size_t side = 60;
  // Points of 1 to 8 mm, each with its own covariance.
  const auto mixed = [](RandomStream& random, double& variance) {
    const double sigma = 0.001 + 0.007 * random.uniform();
    variance = sigma * sigma;
    return sigma * random.normal();
  };
  const Discs a = discs(side, 15, 201, mixed), b = discs(side, 24, 202, mixed);
  for (const Position position : {Position::kMedian, Position::kMean}) {
    M3c2Settings settings = vertical(position);
    settings.precision_from = M3c2Settings::PrecisionFrom::kCovariances;
    settings.surfaces = M3c2Settings::Surfaces::kAll;
    const double share =
        share_within(level_of_detection_cloud_of(a.xyz, a.covariances),
                     level_of_detection_cloud_of(b.xyz, b.covariances), side, settings);
    MESSAGE("FIGURE point covariances, " << name_of(position) << ": " << 100 * share << " %");
    CHECK(share >= 0.93);
    CHECK(share <= 0.97);
    CHECK_THROWS(share_within(level_of_detection_cloud_of(a.xyz),
                              level_of_detection_cloud_of(b.xyz, b.covariances), side, settings));
  }
}

TEST_CASE("lod__quantiles_are_those_of_student") {
  const LevelOfDetection detection(0.95);
  for (const double dof : {1.0, 2.0, 3.3, 5.0, 7.7, 12.0, 30.0, 99.5, 1000.0, 1e7}) {
    const double truth = boost::math::quantile(boost::math::students_t(dof), 0.975);
    CHECK(std::fabs(detection.quantile(dof) / truth - 1) < (dof < 3 ? 1e-7 : 1e-9));
  }
}
