// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "report/pages/clearance_report.h"

#include <doctest/doctest.h>

#include "base/error.h"
#include "unit/report/charts/swept_gauge.h"

using namespace jalon;

namespace {

GaugeRun clearance_run() {
  SweepTables tables = swept::tables();
  return {std::move(tables.places), std::move(tables.intervals),
          swept::corners(),         swept::way(),
          swept::obstacles(),       nullptr};
}

}  // namespace

TEST_CASE("clearance_report__outcome_way_places_sections_and_view") {
  Task task;
  const std::string page = clearance_html(clearance_run(), R"({"title": "<Tunnel>"})", {}, task);
  CHECK(page.find("&lt;Tunnel&gt;") != std::string::npos);
  CHECK(page.find("meets an obstacle, 0.100 m deep") != std::string::npos);
  for (const char* heading :
       {"Clearance along the way", "Tight places", "Sections at the tight places"})
    CHECK(page.find(heading) != std::string::npos);
  CHECK(page.find("In three dimensions") != std::string::npos);
  CHECK(page.find("<td>point 2</td>") != std::string::npos);
}

TEST_CASE("clearance_report__nothing_near_is_told") {
  Task task;
  GaugeRun run = clearance_run();
  const std::vector<ConvexPiece> small{ConvexPiece::sphere({0, 0, 50}, 0.1)};
  SweepTables none = sweep_tables(small, run.poses, run.cloud.get(), nullptr, {}, task);
  run.places = std::move(none.places), run.intervals = std::move(none.intervals);
  run.cloud = nullptr;
  const std::string page = clearance_html(run, "", {}, task);
  CHECK(page.find("Nothing comes near the gauge") != std::string::npos);
  CHECK(page.find("Nothing comes within the margin") != std::string::npos);
  CHECK(page.find("In three dimensions") == std::string::npos);
}

TEST_CASE("clearance_report__other_tables_are_refused") {
  Task task;
  GaugeRun run = clearance_run();
  run.intervals = FieldTable();
  CHECK_THROWS_AS(clearance_html(run, "", {}, task), Error);
}
