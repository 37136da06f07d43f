// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// Precision of planes: the worst direction by search, and the scatter of repeated fits of a plane that is known.
#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/random.h"
#include "report/pages/plane_precision.h"
#include "unit/modelling/walls.h"

using namespace jalon;

TEST_CASE("plane_precision__of_the_normal_is_that_of_its_least_certain_direction") {
  RandomStream random(1, 3);
  for (int trial = 0; trial < 50; ++trial) {
    // A covariance J J^T of the two tilts, with any correlation.
    const double a = random.normal(), b = random.normal(), c = random.normal(), d = random.normal();
    PlaneFit fit;
    fit.local_covariance = {a * a + b * b, a * c + b * d, 0, c * c + d * d, 0, 0.25};
    double most = 0;
    constexpr int kSteps = 4000;
    for (int i = 0; i < kSteps; ++i) {
      const double angle = std::numbers::pi * i / kSteps, u = std::cos(angle), v = std::sin(angle);
      most = std::max(most, std::sqrt(std::pow(u * a + v * c, 2) + std::pow(u * b + v * d, 2)));
    }
    const PlanePrecision precision = plane_precision(fit);
    CHECK(precision.sigma_normal_rad >= most * (1 - 1e-12));
    CHECK(precision.sigma_normal_rad <= most * (1 + 1e-6));  // half a step off: 4e-4^2
    CHECK(precision.sigma_offset_m == 0.5);
  }
  PlaneFit rounded;  // a variance that rounding made negative is none
  rounded.local_covariance = {-1e-20, 0, 0, -1e-20, 0, -1e-20};
  CHECK(plane_precision(rounded).sigma_normal_rad == 0);
  CHECK(plane_precision(rounded).sigma_offset_m == 0);
}

TEST_CASE("plane_precision__is_the_scatter_of_repeated_fits") {
  constexpr int kFits = 600;
  double place = 0, tilt = 0;
  for (uint64_t trial = 0; trial < kFits; ++trial) {
    RandomStream random(7, trial);
    std::vector<Vec3> points(80);  // on z = 0, six times as long as wide
    for (Vec3& p : points) p = {6 * random.uniform(), random.uniform(), 0.004 * random.normal()};
    PlaneFit fit;
    REQUIRE(fit_plane(points, fit));
    const Vec3 n = fit.plane.normal * (fit.plane.normal.z < 0 ? -1.0 : 1.0);
    const PlanePrecision precision = plane_precision(fit);
    place += std::pow(fit.centroid.z / precision.sigma_offset_m, 2);
    tilt += std::pow(n.y / precision.sigma_normal_rad, 2);
  }
  // Four standard deviations of a root mean square; sigma is from 77 degrees of freedom: 1.3 % more.
  const double within = 4 / std::sqrt(2.0 * kFits) + 0.013;
  CHECK(std::abs(std::sqrt(place / kFits) - 1) < within);
  CHECK(std::abs(std::sqrt(tilt / kFits) - 1) < within);
}

TEST_CASE("plane_precision__of_the_scanner_needs_notes_known_influences_and_stations") {
  walls::WallScan wall;
  wall.width = wall.height = 1;
  wall.spacing = 0.1;
  const Segmentation s = walls::segmentation_of({wall.points()});
  const auto status = [&](const char* scanner, std::string& text) {
    Notes notes;
    notes.scanner_json = scanner;
    Task task;
    try {
      scanner_planes(s, notes, task);
    } catch (const Error& error) {
      text = error.what();
      return error.status();
    }
    return Status::kOk;
  };
  std::string text;
  CHECK(status("", text) == Status::kOk);
  Task task;
  CHECK(scanner_planes(s, {}, task).empty());
  CHECK(status(R"({"sigma_nose_m": 1})", text) == Status::kNotFound);
  CHECK(text.find("sigma_nose_m") != std::string::npos);
  CHECK(status(R"({"sigma_range_m": -1})", text) == Status::kInvalidArgument);
  CHECK(status(R"({"sigma_range_m": 0.004})", text) == Status::kInvalidArgument);
  CHECK(text.find("station") != std::string::npos);
}
