// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <cmath>

#include "cloud/precision.h"
#include "unit/cloud/clouds.h"

namespace jalon {
namespace {

using namespace test;

Cloud seen_from(const std::vector<Vec3>& points, const Transform& pose) {
  Cloud cloud = cloud_of(points);
  cloud.stations.push_back({"S", true, pose, 0, points.size()});
  return cloud;
}

std::array<double, 6> covariance_at(const Cloud& cloud, size_t i) {
  std::array<double, 6> out;
  for (uint32_t k = 0; k < 6; ++k) out[k] = cloud.fields.require("covariance").number(i, k);
  return out;
}

ScannerPrecision instrument() {
  ScannerPrecision p;
  p.sigma_range_m = 0.005, p.sigma_horizontal_rad = 1e-4, p.sigma_vertical_rad = 2e-4;
  return p;
}

TEST_CASE("point_covariances__along_x_are_range_horizontal_and_vertical_on_the_diagonal") {
  Task task;
  const Vec3 at{100, 200, 50};
  const Cloud cloud = with_point_covariances(
      seen_from({at + Vec3{20, 0, 0}}, {{1, 0, 0, at.x, 0, 1, 0, at.y, 0, 0, 1, at.z}}),
      instrument(), task);
  const auto c = covariance_at(cloud, 0);
  CHECK(c[0] == doctest::Approx(0.005 * 0.005).scale(0));
  CHECK(c[3] == doctest::Approx(0.002 * 0.002).scale(0));
  CHECK(c[5] == doctest::Approx(0.004 * 0.004).scale(0));
  for (const size_t k : {1, 2, 4}) CHECK(std::abs(c[k]) < 1e-12);
  CHECK(cloud.fields.require("point_sigma").number(0) ==
        doctest::Approx(std::sqrt(25e-6 + 4e-6 + 16e-6)).scale(0));
}

TEST_CASE("point_covariances__use_the_vertical_axis_of_a_station_laid_on_its_side") {
  // The scanner's z is the world's x; what was vertical noise lies along x now.
  const Transform side{{0, 0, 1, 0, 0, 1, 0, 0, -1, 0, 0, 0}};
  Task task;
  const auto c =
      covariance_at(with_point_covariances(seen_from({{0, 10, 0}}, side), instrument(), task), 0);
  CHECK(c[0] == doctest::Approx(0.002 * 0.002).scale(0));
  CHECK(c[3] == doctest::Approx(0.005 * 0.005).scale(0));
  CHECK(c[5] == doctest::Approx(0.001 * 0.001).scale(0));
}

TEST_CASE("point_covariances__each_point_is_seen_from_its_own_station") {
  Cloud cloud = cloud_of({{10, 0, 0}, {10, 0, 0}});
  cloud.stations.push_back({"A", true, Transform(), 0, 1});
  cloud.stations.push_back({"B", true, Transform{{1, 0, 0, 10, 0, 1, 0, -30, 0, 0, 1, 0}}, 1, 1});
  Task task;
  const Cloud out = with_point_covariances(cloud, instrument(), task);
  CHECK(covariance_at(out, 0)[0] == doctest::Approx(0.005 * 0.005).scale(0));
  CHECK(covariance_at(out, 1)[3] == doctest::Approx(0.005 * 0.005).scale(0));
  CHECK(covariance_at(out, 1)[0] == doctest::Approx(0.003 * 0.003).scale(0));
}

TEST_CASE("point_covariances__a_normal_askew_costs_pulse_noise_and_nan_counts_as_square") {
  ScannerPrecision p = instrument();
  p.pulse_bandwidth_hz = 1e9, p.snr = 20, p.snr_range_m = 10;
  const float h = std::sqrt(0.5f), nan = NAN;
  Cloud cloud = seen_from({{10, 0, 0}, {10, 0, 0}, {10, 0, 0}}, Transform());
  Task task;
  const auto without = covariance_at(with_point_covariances(cloud, p, task), 0);
  cloud.fields.set(make_column<float>({"normal", ElementType::kFloat32, 3, "", ""},
                                      std::vector<float>{1, 0, 0, h, h, 0, nan, nan, nan}));
  const Cloud out = with_point_covariances(cloud, p, task);
  CHECK(covariance_at(out, 0)[0] == doctest::Approx(without[0]).scale(0));
  CHECK(covariance_at(out, 1)[0] > 1.1 * without[0]);
  CHECK(covariance_at(out, 2)[0] == doctest::Approx(without[0]).scale(0));
}

TEST_CASE("point_covariances__refuse_points_without_a_pose_or_on_their_station") {
  Task task;
  const auto refusal = [&](const Cloud& cloud) {
    return status_of([&] { with_point_covariances(cloud, instrument(), task); });
  };
  CHECK(refusal(cloud_of({{1, 0, 0}})) == Status::kInvalidArgument);
  CHECK(refusal(seen_from({{1, 0, 0}, {0, 0, 0}}, Transform())) == Status::kInvalidArgument);
  Cloud unposed = seen_from({{1, 0, 0}}, Transform());
  unposed.stations[0].has_pose = false;
  CHECK(refusal(unposed) == Status::kInvalidArgument);
  CHECK(with_point_covariances(cloud_of({}), instrument(), task).size() == 0);
}

}  // namespace
}  // namespace jalon
