// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "base/error.h"
#include "base/random.h"
#include "cloud/precision.h"

using namespace jalon;

namespace {

ScannerPrecision precision(const char* json = "{}") {
  ParamSet params("precision", precision_rows());
  params.from_json(json);
  return settings_from<ScannerPrecision>(params);
}

PointBudget budget(const Vec3& ray, const char* json, double incidence_rad = 0) {
  return point_budget(precision(json), ray, {0, 0, 1}, incidence_rad);
}

Cloud measured_from(const std::vector<Vec3>& points, const Transform& pose) {
  Buffer<double> xyz(3 * points.size());
  for (size_t i = 0; i < points.size(); ++i)
    for (int k = 0; k < 3; ++k) xyz[3 * i + static_cast<size_t>(k)] = points[i][k];
  Cloud cloud = make_cloud(std::move(xyz));
  Station station;
  station.has_pose = true;
  station.pose = pose;
  station.count = points.size();
  cloud.stations.push_back(station);
  return cloud;
}

}  // namespace

TEST_CASE("precision__adds_influences_as_the_root_of_the_sum_of_squares") {
  const char* all =
      R"({"beam_divergence_rad":4e-4,"pulse_bandwidth_hz":1e9,"snr":20,"sigma_station_m":0.003,
    "sigma_station_z_m":0.002,"sigma_instrument_height_m":0.001,"backsight_distance_m":40,"sigma_backsight_m":0.002,
    "level_sensitivity_rad":1e-4,"range_ppm":20})";
  const PointBudget b = budget({0, 60, 25}, all);
  const double d = std::hypot(60, 25);
  CHECK(b.range_m == doctest::Approx(0.007 + 20e-6 * d).scale(0));
  CHECK(b.horizontal_m == doctest::Approx(60 * 60e-6).scale(0));
  CHECK(b.azimuth_m == doctest::Approx(60 * std::sqrt(2.0) * 0.002 / 40).scale(0));
  CHECK(b.levelling_m == doctest::Approx(0.2e-4 * std::hypot(d, 25)).scale(0));
  CHECK(b.station_m == doctest::Approx(std::sqrt(2 * 9e-6 + 4e-6 + 1e-6)).scale(0));
  const double parts[] = {b.range_m,   b.pulse_m,     b.horizontal_m, b.vertical_m,
                          b.azimuth_m, b.levelling_m, b.station_m};
  double sum = 2 * b.beam_m * b.beam_m;  // in both directions across the ray
  for (const double part : parts) sum += part * part;
  CHECK(b.point_m() == doctest::Approx(std::sqrt(sum)).epsilon(1e-12).scale(0));
  CHECK(budget({0, 60, 25}, "{}").point_m() ==
        doctest::Approx(budget({0, 60, 25}, "{}").instrument_m()).scale(0));
}

TEST_CASE("precision__snr_follows_the_returned_intensity") {
  const char* json = R"({"pulse_bandwidth_hz":1e9,"snr":50,"snr_range_m":10,"reflectance":0.5})";
  const double near_by = budget({0, 10, 0}, json).pulse_m;
  CHECK(budget({0, 20, 0}, json).pulse_m == doctest::Approx(4 * near_by).scale(0));
  CHECK(budget({0, 10, 0}, json, 1.0).pulse_m ==
        doctest::Approx(near_by / std::pow(std::cos(1.0), 4)).scale(0));
  CHECK(std::isfinite(budget({0, 10, 0}, json, 1.5707963).point_m()));
}

TEST_CASE("precision__biases_stay_out_of_the_standard_deviations") {
  const char* json =
      R"({"temperature_drift_m_per_k":1.333e-4,"temperature_difference_k":-15,"rise_time_s":1e-9,
    "time_walk_factor":0.1,"amplitude":2})";
  const PointBudget b = budget({0, 10, 0}, json);
  CHECK(b.range_bias_m == doctest::Approx(-15 * 1.333e-4 + 299792458 * 1e-10 * 0.5).scale(0));
  CHECK(b.point_m() == budget({0, 10, 0}, "{}").point_m());
}

TEST_CASE("precision__covariances_of_a_cloud_cover_what_the_scanner_does") {
  // Points all round a turned and tilted scanner on a national grid, drawn as the scanner measures them.
  const double a = 0.8, t = 0.05, ca = std::cos(a), sa = std::sin(a), ct = std::cos(t),
               st = std::sin(t);
  Transform pose;
  pose.m = {ca, -sa * ct, sa * st, 652000, sa, ca * ct, -ca * st, 6861000, 0, st, ct, 130};
  RandomStream random(6, 1);
  std::vector<Vec3> truth, measured;
  const double sd = 0.004, sh = 3e-4, sv = 2e-4;
  const auto place = [&](double d, double h, double v) {
    return pose.point(
        {d * std::cos(v) * std::sin(h), d * std::cos(v) * std::cos(h), d * std::sin(v)});
  };
  for (int k = 0; k < 20000; ++k) {
    const double d = 5 + 45 * random.uniform(), h = 6.2 * random.uniform(),
                 v = -0.9 + 2 * random.uniform();
    truth.push_back(place(d, h, v));
    const Vec3 off{random.normal(), random.normal(), random.normal()};
    measured.push_back(place(d + sd * off.x, h + sh * off.y, v + sv * off.z));
  }
  Task task;
  const Cloud cloud = with_point_covariances(
      measured_from(measured, pose),
      precision(R"({"sigma_range_m":0.004,"sigma_horizontal_rad":3e-4,"sigma_vertical_rad":2e-4})"),
      task);
  const auto c = cloud.fields.require("covariance").values<float>();
  const auto sigma = cloud.fields.require("point_sigma").values<float>();
  double normalised = 0, squares = 0, variances = 0;
  const Vec3 direction = normalized(Vec3{0.4, -0.7, 0.3});
  for (size_t i = 0; i < truth.size(); ++i) {
    const Vec3 error = measured[i] - truth[i];
    const Symmetric3 covariance{c[6 * i],     c[6 * i + 1], c[6 * i + 2],
                                c[6 * i + 3], c[6 * i + 4], c[6 * i + 5]};
    normalised +=
        dot(error, direction) * dot(error, direction) / variance_along(covariance, direction);
    squares += squared_norm(error);
    variances += double{sigma[i]} * sigma[i];
  }
  const double n = static_cast<double>(truth.size());
  MESSAGE("FIGURE point covariances: normalised variance in a direction ", normalised / n,
          ", of the whole ", squares / variances);
  CHECK(normalised / n == doctest::Approx(1).epsilon(0.03));
  CHECK(squares / variances == doctest::Approx(1).epsilon(0.03));
}

TEST_CASE("precision__refuses_points_without_a_place_they_were_seen_from") {
  Task task;
  Cloud cloud = measured_from({{1, 2, 3}, {4, 5, 6}}, Transform{});
  CHECK_NOTHROW(with_point_covariances(cloud, precision(), task));
  cloud.stations[0].count = 1;
  CHECK_THROWS_AS(with_point_covariances(cloud, precision(), task), Error);
  CHECK_THROWS_AS(
      with_point_covariances(measured_from({{0, 0, 0}}, Transform{}), precision(), task), Error);
}
