// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// A comparison of what was seen only, by a method made for it: which points it gets, and where its rows end up.
#include "compare/distance/visible_comparison.h"

#include <doctest/doctest.h>

#include <cmath>

#include "base/table_columns.h"
#include "compare/summary.h"
#include "unit/compare/distance_fixture.h"
#include "unit/compare/lattice.h"

using namespace jalon;
using namespace jalon::test;

namespace {

// A method that says of each point its x as distance and twice, thrice its y; and how many points it was given.
Comparison echo(const CloudPtr&, const CloudPtr& seen, const DistanceSettings&, Task& task) {
  Comparison made;
  made.cloud = seen;
  const std::vector<double> all(seen->size());
  add_column<uint8_t>(made.points, all, "status", "", "", [](double) { return 0; });
  size_t i = 0, j = 0;
  add_column<double>(made.points, all, "distance", "", "",
                     [&](double) { return seen->point(i++).x; });
  add_columns<uint32_t, 2>(made.points, all, "twice", "", "", [&](double, uint32_t* out) {
    const double y = seen->point(j++).y;
    out[0] = static_cast<uint32_t>(2 * y);
    out[1] = static_cast<uint32_t>(3 * y);
  });
  made.summary = summarise(made.points.require("distance").values<double>(),
                           made.points.require("status").values<uint8_t>(), task);
  add_value<uint64_t>(made.summary, "given", "", "", seen->size());
  add_value<double>(made.summary, "same_cloud", "", "", seen->fields.find("mark") != nullptr);
  return made;
}

// Seen by a scanner at the origin: a wall at y = 10, 0.5 rad to either side.
CloudPtr scanned_wall() { return std::make_shared<const Cloud>(lattice({}, {}, wall_at(10))); }

// Before the wall, behind it, beside the field, before it, behind the scanner.
const std::vector<double> kPlaces = {1, 5, 0, 1, 20, 0, 9, 3, 0, 2, 8, 1, 0, -5, 0};
const uint8_t kStatuses[] = {0, 1, 3, 0, 3};

Comparison of_visible(const CloudPtr& places, bool with_spacing = false) {
  DistanceSettings settings;
  settings.visibility = DistanceSettings::VisibleFrom::kStations;
  settings.reference_spacing = with_spacing;
  Task task;
  return compare_visible(scanned_wall(), places, settings, echo, task);
}

CloudPtr marked(const std::vector<double>& xyz) {
  Cloud cloud = *cloud_of(xyz);
  const std::vector<double> rows(cloud.size());
  add_column<double>(cloud.fields, rows, "mark", "", "", [](double) { return 1; });
  return std::make_shared<const Cloud>(cloud);
}

}  // namespace

TEST_CASE("compare_visible__gives_seen_points_their_rows_and_others_a_status_without_a_value") {
  const CloudPtr places = marked(kPlaces);
  const Comparison made = of_visible(places);
  CHECK(made.cloud == places);
  CHECK(summary(made, "given") == 2);
  CHECK(summary(made, "points") == 5);
  CHECK(summary(made, "compared") == 2);
  CHECK(summary(made, "hidden") == 1);
  CHECK(summary(made, "out_of_field") == 2);
  CHECK(summary(made, "mean") == 1.5);
  for (size_t i = 0; i < 5; ++i) {
    const auto number = [&](const char* name, uint32_t component = 0) {
      return made.points.require(name).number(i, component);
    };
    CHECK(number("status") == kStatuses[i]);
    const Vec3 p = places->point(i);
    if (kStatuses[i] == 0) {
      CHECK(number("distance") == p.x);
      CHECK(number("twice", 0) == 2 * p.y);
      CHECK(number("twice", 1) == 3 * p.y);
    } else {
      CHECK(std::isnan(number("distance")));
      CHECK(number("twice", 0) == kNoPoint);
      CHECK(number("twice", 1) == kNoPoint);
    }
  }
}

TEST_CASE("compare_visible__hands_on_the_cloud_itself_where_all_is_seen") {
  const CloudPtr places = marked({1, 5, 0, 2, 8, 1});
  CHECK(summary(of_visible(places), "same_cloud") == 1);
  CHECK(summary(of_visible(marked(kPlaces)), "same_cloud") == 0);  // points alone
}

TEST_CASE("compare_visible__asks_no_method_where_nothing_is_seen") {
  const Comparison made = of_visible(cloud_of({1, 20, 0, 0, -5, 0}));
  CHECK(made.summary.find("given") == nullptr);
  CHECK(summary(made, "compared") == 0);
  CHECK(std::isnan(summary(made, "mean")));
  REQUIRE(made.points.require("distance").count() == 2);
  CHECK(std::isnan(made.points.require("distance").number(0)));
  CHECK(made.points.require("status").number(0) == 1);
  CHECK(made.points.require("nearest").number(1) == kNoPoint);
}

TEST_CASE("compare_visible__tells_the_spacing_of_the_reference_where_asked") {
  CHECK(of_visible(cloud_of({1, 5, 0})).points.find("reference_spacing") == nullptr);
  const Comparison made = of_visible(cloud_of({0, 5, 0, 0, 9.9, 0, 0, -5, 0}), true);
  const Column& spacing = made.points.require("reference_spacing");
  // Rays are 0.01 rad apart on the wall 10 m away and cells one and a half of that wide: the points of
  // neighbouring cells are one ray or two apart, whichever point along the ray is asked for.
  for (size_t i = 0; i < 2; ++i) {
    CHECK(spacing.number(i) > 0.09);
    CHECK(spacing.number(i) < 0.21);
  }
  CHECK(std::isnan(spacing.number(2)));
}
