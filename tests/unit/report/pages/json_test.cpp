// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// The report as JSON, read by another reader: numbers to the last bit, residuals against a recount.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "base/error.h"
#include "report/report.h"
#include "unit/modelling/walls.h"

using namespace jalon;

namespace {

Segmentation turned_wall() {
  walls::WallScan wall;
  wall.width = 5;
  wall.height = 3;
  wall.spacing = 0.05;
  wall.shift = {652000, 6861000, 30};
  Segmentation out = walls::segmentation_of({wall.points()});
  out.T_facade_world.m = {0.6, 0.8, 0, 1.0 / 3, -0.8, 0.6, 0, -7, 0, 0, 1, 0.1};
  return out;
}

nlohmann::ordered_json report_of(const Segmentation& segmentation, std::string_view notes = "") {
  Task task;
  return nlohmann::ordered_json::parse(report_json(segmentation, {}, notes, task));
}

}  // namespace

TEST_CASE("json__numbers_of_the_planes_read_back_to_the_same_bits") {
  const Segmentation s = turned_wall();
  const auto json = report_of(s);
  const PlaneFit& fit = s.segments[0].fit;
  const auto& plane = json["planes"][0];
  for (int k = 0; k < 3; ++k) {
    CHECK(plane["normal"][static_cast<size_t>(k)] == fit.plane.normal[k]);
    CHECK(plane["centroid"][static_cast<size_t>(k)] == fit.centroid[k]);
  }
  CHECK(plane["offset_m"] == fit.plane.offset);
  CHECK(plane["sigma_m"] == fit.sigma);
  CHECK(plane["orientation"] == "parallel");
  REQUIRE(json["T_facade_world"].size() == 12);
  for (size_t i = 0; i < 12; ++i) CHECK(json["T_facade_world"][i] == s.T_facade_world.m[i]);
}

TEST_CASE("json__residual_bins_agree_with_a_recount") {
  const Segmentation s = turned_wall();
  const auto r = report_of(s)["residuals"];
  const double from = r["from_m"], to = r["to_m"];
  const size_t bins = r["bins"].size();
  std::vector<int64_t> counts(bins, 0);
  uint64_t below = 0, above = 0;
  double sum = 0;
  for (const float value : s.residuals->values<float>()) {
    sum += value;
    below += value < from;
    above += value > to;
    const double at = (value - from) / (to - from) * static_cast<double>(bins);
    if (value >= from && value <= to) ++counts[std::min(bins - 1, static_cast<size_t>(at))];
  }
  CHECK(r["count"] == s.cloud->size());
  CHECK(r["below"] == below);
  CHECK(r["above"] == above);
  CHECK(std::abs(r["mean_m"].get<double>() - sum / static_cast<double>(s.cloud->size())) < 1e-9);
  CHECK(to == -from);
  CHECK(to > 0.0155);  // four sigma of about 4 mm
  int64_t differing = 0;
  for (size_t i = 0; i < bins; ++i) differing += std::abs(counts[i] - r["bins"][i].get<int64_t>());
  CHECK(differing <= 4);  // values on the edge of two bins
}

TEST_CASE("json__what_is_not_known_is_null_or_absent") {
  Segmentation s = turned_wall();
  Segment none;
  none.label = 2;
  none.fit.plane.offset = none.fit.sigma = NAN;
  s.segments.push_back(none);
  const auto json = report_of(s);
  REQUIRE(json["planes"].size() == 2);
  CHECK(json["planes"][1]["offset_m"].is_null());
  CHECK(json["planes"][1]["sigma_m"].is_null());
  CHECK(json["planes"][1]["label"] == 2);
  CHECK(!json.contains("scanner"));
  CHECK(!json["planes"][0].contains("variance_factor"));
  for (const char* name : {"spheres", "cylinders", "faces", "openings", "opening_types", "parts"})
    CHECK_MESSAGE((json.contains(name) && json[name].is_array() && json[name].empty()), name);
}

TEST_CASE("json__notes_and_parameters_are_handed_through_in_their_order") {
  Segmentation s = turned_wall();
  s.parameters_json = R"({"gap_m": 0.25, "method": "ransac", "list": [1, 2.5], "flag": true})";
  Cloud cloud = *s.cloud;
  cloud.crs = "EPSG:2154";
  s.cloud = std::make_shared<const Cloud>(cloud);
  const auto json = report_of(
      s, R"({"title": "T \"1\"", "input": {"z": "a", "b": 3}, "times": {"read": 0.1, "all": 7}})");
  CHECK(json["title"] == "T \"1\"");
  CHECK(json["crs"] == "EPSG:2154");
  CHECK(json["points"] == s.cloud->size());
  CHECK(json["parameters"] == nlohmann::ordered_json::parse(s.parameters_json));
  CHECK(json["input"].begin().key() == "z");
  CHECK(json["input"]["b"] == "3");
  CHECK(json["times_s"]["read"] == 0.1);
  s.parameters_json.clear();
  CHECK(report_of(s)["parameters"].empty());
  try {
    report_of(s, "[]");
    CHECK(false);
  } catch (const Error& error) {
    CHECK(error.status() == Status::kInvalidArgument);
  }
}
