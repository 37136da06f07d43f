// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// The chapter on precision: closed forms for a rectangle of points, and a scanner whose noise is known.
#include <doctest/doctest.h>

#include <cmath>
#include <string>

#include "base/error.h"
#include "report/pages/html_model.h"
#include "unit/modelling/walls.h"
#include "unit/report/pages/page_scenes.h"

using namespace jalon;
using page_scenes::has;
using page_scenes::tables_of;

namespace {

constexpr double kWidth_m = 6, kHeight_m = 2, kNoise_m = 0.004;

Segmentation rectangle_with_station() {
  walls::WallScan wall;
  wall.width = kWidth_m;
  wall.height = kHeight_m;
  wall.noise = kNoise_m;
  wall.azimuth = 0;
  wall.spacing = 0.05;
  wall.jitter = 1;
  Segmentation out = walls::segmentation_of({wall.points()});
  Cloud cloud = *out.cloud;
  Station station;
  station.has_pose = true;
  station.pose.m = {1, 0, 0, 3, 0, 1, 0, -60, 0, 0, 1, 1};
  station.count = cloud.size();
  cloud.stations.push_back(station);
  out.cloud = std::make_shared<const Cloud>(cloud);
  return out;
}

std::string precision_page(const Segmentation& segmentation, const std::string& scanner = "") {
  Notes notes;
  notes.scanner_json = scanner;
  Page page;
  Task task;
  add_precision(page, segmentation, notes, task);
  return page.html().take();
}

std::string range_noise(const std::string& sigma_m) {
  return "{\"sigma_range_m\": " + sigma_m +
         ", \"sigma_horizontal_rad\": 0, \"sigma_vertical_rad\": 0}";
}

}  // namespace

TEST_CASE("html_precision__sigmas_of_a_rectangle_are_those_of_the_closed_form") {
  const Segmentation s = rectangle_with_station();
  const double n = static_cast<double>(s.cloud->size());
  const auto table = tables_of(precision_page(s), "Precision").at(0);
  REQUIRE(table.size() == 2);
  const auto& row = table[1];
  REQUIRE(row.size() == 5);
  CHECK(row[1] == std::to_string(s.cloud->size()));
  const double relative = 4 / std::sqrt(2 * n);  // four sigmas of an estimated sigma
  CHECK(std::abs(markup::number(row[2]) - 1000 * kNoise_m) < 1000 * kNoise_m * relative + 0.005);
  // About the long axis the points reach least: their variance across it is height^2 / 12.
  const double normal_mrad = 1000 * kNoise_m / (std::sqrt(n / 12) * kHeight_m);
  CHECK(std::abs(markup::number(row[3]) - normal_mrad) < 1.5 * normal_mrad * relative + 5e-5);
  const double place_mm = 1000 * kNoise_m / std::sqrt(n);
  CHECK(std::abs(markup::number(row[4]) - place_mm) < place_mm * relative + 5e-4);
}

TEST_CASE("html_precision__the_variance_factor_is_the_square_of_noise_over_the_scanner's") {
  const Segmentation s = rectangle_with_station();
  const double n = static_cast<double>(s.cloud->size());
  for (const double factor : {1.0, 2.0}) {
    const std::string html = precision_page(s, range_noise(factor == 1 ? "0.004" : "0.008"));
    const auto tables = tables_of(html, "Precision");
    REQUIRE(tables.size() == 2);
    REQUIRE(tables[0].size() >= 1);
    bool is_told = false;
    for (const auto& told : tables[0]) {
      is_told |= told[0] == "sigma_range_m";
      CHECK(told[0] != "sigma_horizontal_rad");  // an influence of 0 is left out
    }
    CHECK(is_told);
    const auto& row = tables[1].at(1);
    REQUIRE(row.size() == 7);
    // Rays from 60 m meet the wall within 0.06 rad of its normal: 0.2 % less at most.
    CHECK(std::abs(markup::number(row[5]) - 4 * factor) < 0.002 * 4 * factor + 0.005);
    const double expected = 1 / (factor * factor);
    CHECK(std::abs(markup::number(row[6]) - expected) <
          expected * (4 * std::sqrt(2 / n) + 0.004) + 5e-4);
  }
}

TEST_CASE("html_precision__planes_without_a_fit_are_left_out_and_stations_are_needed") {
  Segmentation s = rectangle_with_station();
  Segment none = s.segments[0];
  none.label = 2;
  none.fit.plane.offset = NAN;
  s.segments.push_back(none);
  CHECK(tables_of(precision_page(s), "Precision").at(0).size() == 2);
  CHECK(precision_page(walls::segmentation_of({})).empty());
  Cloud cloud = *s.cloud;
  cloud.stations.clear();
  s.cloud = std::make_shared<const Cloud>(cloud);
  CHECK(!has(precision_page(s), "variance factor"));
  try {
    precision_page(s, range_noise("0.004"));
    CHECK(false);
  } catch (const Error& error) {
    CHECK(error.status() == Status::kInvalidArgument);
    CHECK(has(error.what(), "station"));
  }
}
