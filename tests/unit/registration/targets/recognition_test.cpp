// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Targets found in a whole scan by their brightness, with the code of their kind and size, or none.

#include "registration/targets/recognition.h"

#include <doctest/doctest.h>

#include <cmath>

#include "base/error.h"
#include "registration/targets/measure.h"
#include "unit/cloud/clouds.h"
#include "unit/registration/target_walls.h"

using namespace jalon;
using namespace jalon::test;

namespace {

constexpr const char* kCatalogue = R"({"targets": [
  {"code": "1", "name": "wall", "kind": "checker", "size_m": 0.15},
  {"code": 2, "name": "door", "kind": "checker", "size_m": 0.1},
  {"code": "3", "name": "window", "kind": "disc", "size_m": 0.1}]})";

std::vector<RecognisedTarget> recognised(const Cloud& cloud, const char* catalogue) {
  Task task;
  return recognised_targets(cloud, target_catalogue_from_json(catalogue), MeasuringSettings{},
                            task);
}

TargetWall plain_wall() {
  TargetWall wall;
  wall.width_m = 3, wall.height_m = 2;
  wall.sheets = {checker_sheet(0.7, 1, 0.2, 0.15), checker_sheet(1.5, 1.2, 0.5, 0.1, 0.01),
                 disc_sheet(2.3, 0.8, 0.1)};
  return wall;
}

}  // namespace

TEST_CASE("recognition__finds_kind_size_and_code_of_targets_on_a_wall") {
  const TargetWall wall = plain_wall();
  const auto found = recognised(scan_of(wall, 1), kCatalogue);
  REQUIRE(found.size() == 3);
  for (size_t i = 0; i < 3; ++i) {
    CHECK(found[i].verdict == TargetVerdict::kKnown);
    CHECK(found[i].entry == static_cast<int32_t>(i));
    CHECK(norm(found[i].centre() - place_of(wall, wall.sheets[i])) < 0.001);
  }
}

TEST_CASE("recognition__gives_no_code_where_two_entries_fit_or_none") {
  const TargetWall wall = plain_wall();
  const Cloud cloud = scan_of(wall, 2);
  const auto found = recognised(cloud, R"({"targets": [
    {"code": "1", "kind": "checker", "size_m": 0.149}, {"code": "9", "kind": "checker", "size_m": 0.151},
    {"code": "5", "kind": "checker", "size_m": 0.12}, {"code": "3", "kind": "disc", "size_m": 0.115}]})");
  REQUIRE(found.size() == 3);
  CHECK(found[0].verdict == TargetVerdict::kAmbiguous);
  CHECK(found[0].entry + found[0].second == 1);  // both, in either order
  CHECK(found[0].confidence < 0.9);
  CHECK(found[1].verdict == TargetVerdict::kForeign);  // a checker of 0.1 m
  CHECK(found[1].entry == -1);
  CHECK(found[2].verdict == TargetVerdict::kForeign);
  CHECK(found[2].confidence > 0.9);  // a target it is
}

TEST_CASE("recognition__finds_nothing_on_a_wall_of_windows_stripes_and_tiles") {
  TargetWall wall = plain_wall();
  const auto board = [](double x, double y) {
    const double tiles = std::floor(x / 0.1) + std::floor(y / 0.1);
    return std::fmod(std::fabs(tiles), 2) < 0.5 ? 0.9 : 0.1;
  };
  const auto stripes = [](double x, double) {
    return std::fmod(std::fabs(x), 0.06) < 0.03 ? 0.9 : 0.1;
  };
  const auto cross = [](double x, double y) {
    return std::min(std::fabs(x), std::fabs(y)) < 0.02 ? 0.9 : 0.1;
  };
  wall.sheets = {{0.7, 1, 0, 0.3, 0.005, board},
                 {1.5, 1.2, 0.3, 0.2, 0.005, stripes},
                 {2.3, 0.8, 0, 0.25, 0.005, cross}};
  CHECK(recognised(scan_of(wall, 3), kCatalogue).empty());
}

TEST_CASE("recognition__reads_no_disc_in_a_noisy_square_or_in_a_quadrant") {
  TargetWall wall = plain_wall();
  wall.width_m = 2, wall.spacing_m = 0.009, wall.spot_m = 0.011, wall.brightness_noise = 0.13;
  const Sheet square{1.4,
                     1,
                     0,
                     0.15,
                     0.005,
                     [](double x, double y) {
        return std::max(std::fabs(x), std::fabs(y)) < 0.06 ? 0.08 : 0.9; }};
  wall.sheets = {checker_sheet(0.6, 1, 0.2, 0.15), square};
  for (uint64_t seed = 11; seed < 13; ++seed) {
    const auto found = recognised(scan_of(wall, seed), kCatalogue);
    REQUIRE(found.size() == 1);
    CHECK(found[0].measured.kind == TargetKind::kChecker);
  }
}

TEST_CASE("recognition__reads_sizes_on_a_dark_wall") {
  TargetWall wall = plain_wall();
  wall.wall_brightness = 0.12, wall.wave_m = 0.015, wall.pitch_m = 0.1, wall.oblique_rad = 0.5;
  wall.sheets = {checker_sheet(0.7, 1, 0.2, 0.15), checker_sheet(1.5, 1.2, 0.5, 0.1)};
  const auto found = recognised(scan_of(wall, 6), kCatalogue);
  REQUIRE(found.size() == 2);
  for (size_t i = 0; i < 2; ++i) {
    CHECK(found[i].verdict == TargetVerdict::kKnown);
    CHECK(found[i].entry == static_cast<int32_t>(i));
  }
}

TEST_CASE("recognition__says_what_a_scan_lacks") {
  Task task;
  const auto status = [&](const Cloud& cloud) {
    return status_of([&] { recognised(cloud, kCatalogue); });
  };
  TargetWall wall = plain_wall();
  wall.spacing_m = 0.05;
  Cloud cloud = scan_of(wall, 4, false);
  CHECK(status(cloud) == Status::kNotFound);
  cloud.fields.set(
      make_column<uint16_t>({.name = "intensity"}, std::vector<uint16_t>(cloud.size(), 7)));
  CHECK(status(cloud) == Status::kInsufficientData);
}

TEST_CASE("recognition__is_a_table_of_targets_without_places") {
  const TargetWall wall = plain_wall();
  const Cloud cloud = scan_of(wall, 5);
  MeasuringSettings settings;
  settings.catalogue = kCatalogue;
  Task task;
  const FieldTable table = measure_targets(cloud, {}, settings, task);
  REQUIRE(table.require("size").values<double>().size() == 3);
  CHECK(table.require("entry").number(1) == 1);
  CHECK(table.require("verdict").number(1) == 1);
  CHECK(table.require("size").number(1) == doctest::Approx(0.1).epsilon(0.03).scale(0));
  Task one({.threads = 1});
  const FieldTable again = measure_targets(cloud, {}, settings, one);
  for (uint32_t k = 0; k < 3; ++k)
    CHECK(again.require("centre").number(2, k) == table.require("centre").number(2, k));
  const Vec3 place{1, 1, 1};
  CHECK(status_of([&] {
          measure_targets(cloud, {&place, 1}, settings, task);
        }) == Status::kInvalidArgument);
}

TEST_CASE("judge__follows_the_size_and_its_sigma") {
  const TargetCatalogue catalogue = target_catalogue_from_json(kCatalogue);
  RecognisedTarget target;
  target.measured.kind = TargetKind::kChecker;
  target.pattern_confidence = 0.99;
  target.size_m = 0.101, target.size_sigma_m = 0.001;
  judge(catalogue, 0.9, target);
  CHECK(target.verdict == TargetVerdict::kKnown);
  CHECK(target.entry == 1);
  target.size_m = 0.125;
  judge(catalogue, 0.9, target);
  CHECK(target.verdict == TargetVerdict::kForeign);
  target.size_sigma_m = 0.02;  // either
  judge(catalogue, 0.9, target);
  CHECK(target.verdict == TargetVerdict::kAmbiguous);
  CHECK(target.second >= 0);
  target.size_m = 0.1, target.size_sigma_m = 0.001, target.pattern_confidence = 0.6;
  judge(catalogue, 0.9, target);
  CHECK(target.verdict == TargetVerdict::kUncertain);
}
