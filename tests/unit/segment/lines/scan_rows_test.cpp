// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/lines/scan_rows.h"

#include <doctest/doctest.h>

#include <cmath>
#include <set>

#include "base/error.h"
#include "unit/segment/lines/scanned.h"

using namespace jalon;
using namespace jalon::test;

TEST_CASE("scan_rows__by_fields_are_those_of_the_grid_in_order") {
  const Scanned scanned(scanned_house(), 0.02, 0, 1);
  Task task;
  const auto places = scan_places(*scanned.cloud(true), task);
  REQUIRE(places.size() == scanned.scene.points.size());
  for (size_t i = 0; i < places.size(); ++i) {
    CHECK(places[i].row == scanned.rows[places[i].point]);
    if (i > 0 && places[i].row == places[i - 1].row) CHECK(places[i].along > places[i - 1].along);
    if (i > 0) CHECK(places[i].row >= places[i - 1].row);
  }
}

TEST_CASE("scan_rows__by_angles_are_about_as_many_and_narrow") {
  const Scanned scanned(scanned_house(), 0.01, 0, 1);
  Task task;
  const auto places = scan_places(*scanned.cloud(false, {100, 200, 5}), task);
  REQUIRE(places.size() == scanned.scene.points.size());
  const std::set<uint32_t> true_rows(scanned.rows.begin(), scanned.rows.end());
  std::set<uint64_t> rows;
  for (const ScanPlace& place : places) rows.insert(place.row);
  CHECK(rows.size() > true_rows.size() / 2);
  CHECK(rows.size() < 2 * true_rows.size());
}

TEST_CASE("scan_rows__of_a_cloud_that_nobody_scanned_are_unsupported") {
  Task task;
  try {
    scan_places(*cloud_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}), task);
    FAIL("no error");
  } catch (const Error& error) {
    CHECK(error.status() == Status::kUnsupported);
  }
}

TEST_CASE("scan_rows__of_two_stations_are_apart_even_with_equal_numbers") {
  const Scanned scanned(scanned_house(), 0.05, 0, 1);
  auto cloud = std::make_shared<Cloud>(*scanned.cloud(true));
  const size_t half = cloud->size() / 2;
  for (size_t s = 0; s < 2; ++s) {
    Station station;
    station.first = s * half;
    station.count = s == 0 ? half : cloud->size() - half;
    cloud->stations.push_back(station);
  }
  Task task;
  const auto places = scan_places(*cloud, task);
  for (size_t i = 1; i < places.size(); ++i)
    if (places[i].row == places[i - 1].row)
      CHECK((places[i].point < half) == (places[i - 1].point < half));
}
