// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <cmath>

#include "base/distributions.h"
#include "base/random.h"
#include "cloud/precision.h"
#include "segment/labels/propagated_planes.h"

using namespace jalon;

namespace {

constexpr double kRangeSigma_m = 0.004, kAngleSigma_rad = 3e-4;

ScannerPrecision precision() {
  ScannerPrecision out;
  out.sigma_range_m = kRangeSigma_m;
  out.sigma_horizontal_rad = out.sigma_vertical_rad = kAngleSigma_rad;
  out.sigma_station_m = 5;  // shared by all points: not noise of a plane
  return out;
}

// A wall of 12 x 6 m on y = 0 seen at a slant from a station 4 m before its left end, with the scanner's noise.
Segmentation scanned_wall(uint64_t seed, const Vec3& shift) {
  const Vec3 station = Vec3{0, -4, 1.7} + shift;
  Buffer<double> xyz(3 * 600);
  auto labels = std::make_shared<Column>(FieldInfo{"label", ElementType::kUint32, 1, "", ""}, 600);
  RandomStream random(seed, 5);
  std::vector<Vec3> points;
  for (size_t i = 0; i < 600; ++i) {
    const Vec3 ray = Vec3{0.4 * static_cast<double>(i % 30), 0, 0.3 * static_cast<double>(i / 30)} +
                     shift - station;
    const double d = norm(ray) + kRangeSigma_m * random.normal(), h = std::atan2(ray.x, ray.y),
                 v = std::atan2(ray.z, std::hypot(ray.x, ray.y));
    const double hn = h + kAngleSigma_rad * random.normal(),
                 vn = v + kAngleSigma_rad * random.normal();
    points.push_back(station + Vec3{d * std::cos(vn) * std::sin(hn),
                                    d * std::cos(vn) * std::cos(hn), d * std::sin(vn)});
    for (int k = 0; k < 3; ++k) xyz[3 * i + static_cast<size_t>(k)] = points[i][k];
    labels->values<uint32_t>()[i] = 1;
  }
  Cloud cloud = make_cloud(std::move(xyz));
  Station place;
  place.has_pose = true;
  place.pose.m = {1, 0, 0, station.x, 0, 1, 0, station.y, 0, 0, 1, station.z};
  place.count = 600;
  cloud.stations.push_back(place);
  Segmentation out;
  out.cloud = std::make_shared<const Cloud>(std::move(cloud));
  out.labels = labels;
  Segment segment;
  segment.label = 1;
  fit_plane(points, segment.fit);
  if (segment.fit.plane.normal.y > 0) turn_over(segment.fit);
  out.segments.push_back(segment);
  return out;
}

}  // namespace

TEST_CASE("propagated_planes__covariance_covers_the_true_plane") {
  const Vec3 shift{1000, 2000, 50};
  const int draws = 1000;
  double factor = 0, weighted = 0, plain = 0;
  int covered = 0;
  const Vec3 corner = shift + Vec3{12, 0, 6};  // where the wall ends, seen flattest
  for (int k = 0; k < draws; ++k) {
    Task task;
    const Segmentation wall = scanned_wall(static_cast<uint64_t>(k), shift);
    const auto planes = propagate_planes(wall, precision(), task);
    REQUIRE(planes.size() == 1);
    const PropagatedPlane& p = planes[0];
    factor += p.variance_factor / draws;
    // Height of the plane over the true wall at the corner, with the variance told there.
    const double error = p.plane.distance(corner);
    const double g[4] = {-corner.x, -corner.y, -corner.z, 1};
    double variance = 0;
    for (size_t i = 0; i < 4; ++i)
      for (size_t j = 0; j < 4; ++j) variance += g[i] * p.covariance[4 * i + j] * g[j];
    covered += error * error < chi_square_quantile(1, 0.95) * variance;
    weighted += error * error;
    const Plane& unweighted = wall.segments[0].fit.plane;
    plain += unweighted.distance(corner) * unweighted.distance(corner);
  }
  MESSAGE("FIGURE planes from point covariances: variance factor ", factor, ", 95 % covers ",
          100.0 * covered / draws, " %, rms at a corner ", 1000 * std::sqrt(weighted / draws),
          " mm against ", 1000 * std::sqrt(plain / draws), " mm unweighted");
  CHECK(factor == doctest::Approx(1).epsilon(0.02));
  CHECK(covered > 0.93 * draws);
  CHECK(covered < 0.97 * draws);
  CHECK(weighted < plain);
}

TEST_CASE("propagated_planes__leave_other_segments_unknown") {
  Segmentation s = scanned_wall(1, {});
  s.segments[0].type = PrimitiveType::kSphere;
  Task task;
  const auto planes = propagate_planes(s, precision(), task);
  CHECK(planes[0].label == 1);
  CHECK(std::isnan(planes[0].plane.offset));
  CHECK(std::isnan(planes[0].covariance[3]));
  CHECK(std::isnan(propagated_plane_table(planes).require("variance_factor").number(0)));
}
