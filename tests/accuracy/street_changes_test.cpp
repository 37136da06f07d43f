// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// The street's two epochs as files without stations hold them, by what the command line does by default: each of the
// changes once, with its class, and hardly anything else. Of the scene's eight the first patch, of 5 mm, lies behind a
// box: both stations together have a handful of points on it, and nothing can be told. From three stations each may
// have too few: what is asked of them is what exceeds its level of detection.
#include <doctest/doctest.h>

#include <array>

#include "compare/changes/diagnosis.h"
#include "compare/detection/found_stations.h"
#include "compare/distance/distance.h"
#include "recipe.h"
#include "scan/scanner.h"
#include "seed_range.h"

namespace jalon::street_changes_test {

using namespace jalon::test;

namespace {

constexpr double kTurn_rad = 17 * 0.017453292519943295;  // of the scene "street"

struct Planted {
  const char* name;
  ChangeClass change_class;
  Box3 box;  ///< in the street's own axes
};

// A patch of a facade, along the street from x0 to x1.
Planted patch(const char* name, double x0, double x1, double y) {
  return {name, ChangeClass::kDeformationOverlap, {{x0, y, 0.05}, {x1, y, 1.15}}};
}

const std::array<Planted, 7>& planted() {
  static const std::array<Planted, 7> all{{
      patch("20 mm", 24, 30, 8.35),
      patch("100 mm", 44, 50, 7.75),
      patch("-20 mm", 10, 16, -8.2),
      patch("5 mm", 22, 38, -8),
      {"new box", ChangeClass::kAppearance, {{22, -4.6, 0}, {26.2, -2.8, 1.5}}},
      {"new pole", ChangeClass::kAppearance, {{26.9, 3.9, 0}, {27.1, 4.1, 6}}},
      {"box gone", ChangeClass::kDisappearance, {{32, -4.5, 0}, {36.4, -2.7, 1.4}}},
  }};
  return all;
}

/// more: of the scanner's parameters, ", ..." after those of the steps.
CloudPtr scanned_street(int epoch, double step_rad, uint64_t seed, const std::string& more = "") {
  const std::string scene = "{\"name\": \"street\", \"epoch\": " + std::to_string(epoch) + "}";
  const std::string step = std::to_string(step_rad);
  const std::string scanner =
      "{\"horizontal_step_rad\": " + step + ", \"vertical_step_rad\": " + step + more + "}";
  const Recipe made(scene.c_str(), "static", scanner.c_str(), seed);
  auto cloud = std::make_shared<Cloud>(*made.cloud);
  cloud->stations.clear();  // LAS has none
  return cloud;
}

// The patch of 5 mm that a box hides from two stations: it need not be found.
const Planted& hidden_patch() {
  static const Planted hidden = patch("5 mm behind a box", 4, 10, 8);
  return hidden;
}

constexpr double kOfDensities = 10;

// From three tripods of its own, the finest with ten times as many points a solid angle as the coarsest; LAS has none
// of them.
CloudPtr scanned_unevenly(int epoch, double finest_rad, uint64_t seed) {
  Task task;
  SceneSettings scene;
  scene.name = SceneName::kStreet;
  scene.epoch = epoch;
  const Model street = build_scene(scene, task);
  // The second epoch's tripods stand a step aside.
  const Vec3 aside = epoch == 1 ? Vec3{} : Vec3{1.2, -0.6, 0.1};
  std::vector<ScanStation> stations = automatic_stations(street, 3, 0);
  Cloud all;
  for (size_t k = 0; k < stations.size(); ++k) {
    for (int c = 0; c < 3; ++c) stations[k].pose.m[4 * c + 3] += aside[c];
    // Steps 1, 1.8 and 3.2 times the finest.
    const double coarser = std::pow(kOfDensities, static_cast<double>((k + seed) % 3) / 4);
    const StaticSettings scanner{.horizontal_step_rad = coarser * finest_rad,
                                 .vertical_step_rad = coarser * finest_rad,
                                 .seed = 3 * seed + k};
    Cloud one = scan_static(street, std::span(&stations[k], 1), scanner, task);
    all = k == 0 ? std::move(one) : append(all, one, task);
  }
  all.stations.clear();
  return std::make_shared<const Cloud>(std::move(all));
}

Diagnosis diagnosed(const Comparison& forward, const Comparison& reverse) {
  Task task;
  return diagnose(forward, reverse, {}, task);
}

Comparison detected(const CloudPtr& reference, const CloudPtr& compared) {
  Task task;
  DistanceSettings settings;
  settings.detection = true;
  settings.visibility = DistanceSettings::VisibleFrom::kFound;
  return compare_distance(reference, compared, settings, task);
}

Vec3 in_street(const Vec3& p) {
  const double c = std::cos(kTurn_rad), s = std::sin(kTurn_rad);
  return {c * p.x + s * p.y, -s * p.x + c * p.y, p.z};
}

Vec3 place_of(const Diagnosis& found, const Change& change) {
  Vec3 sum;
  for (const uint32_t i : change.object.before) sum += found.before.cloud().point(i);
  for (const uint32_t i : change.object.after) sum += found.after.cloud().point(i);
  return in_street(sum /
                   static_cast<double>(change.object.before.size() + change.object.after.size()));
}

struct StreetTally {
  size_t runs = 0, right = 0, wrong_class = 0, pieces = 0, invented = 0, most_invented = 0;
};

bool is_at(const Planted& planted, const Vec3& p) {
  constexpr double kMargin_m = 0.3;
  const Vec3 d{kMargin_m, kMargin_m, kMargin_m};
  return Box3{planted.box.min - d, planted.box.max + d}.contains(p);
}

/// How often each planted change was found.
std::array<int, 7> score(const Diagnosis& found, StreetTally& tally) {
  std::array<int, 7> times{};
  size_t invented = 0;
  for (const Change& change : found.changes) {
    const Vec3 p = place_of(found, change);
    bool is_planted =
        is_at(hidden_patch(), p) && change.change_class == hidden_patch().change_class;
    for (size_t k = 0; k < planted().size(); ++k) {
      if (!is_at(planted()[k], p)) continue;
      is_planted = true;
      if (times[k]++ > 0) ++tally.pieces;
      else if (change.change_class == planted()[k].change_class) ++tally.right;
      else ++tally.wrong_class;
      break;
    }
    if (!is_planted) {
      ++invented;
      MESSAGE("invented: class " << static_cast<int>(change.change_class) << " at " << p.x << " "
                                 << p.y << " " << p.z << ", confidence " << change.confidence);
    }
  }
  for (size_t k = 0; k < times.size(); ++k)
    if (times[k] != 1)
      MESSAGE(std::string(planted()[k].name) << ": found " << times[k] << " times");
  ++tally.runs;
  tally.invented += invented;
  tally.most_invented = std::max(tally.most_invented, invented);
  return times;
}

void report(const char* name, const StreetTally& tally) {
  MESSAGE("FIGURE " << std::string(name) << ": right " << tally.right << " of "
                    << planted().size() * tally.runs << ", wrong class " << tally.wrong_class
                    << ", further pieces " << tally.pieces << ", invented " << tally.invented
                    << " in " << tally.runs << " runs, at most " << tally.most_invented
                    << " in one");
}

// Of a patch: can half of the points on it tell its size? Their levels of detection, of both ways.
bool exceeds_detection(const Planted& patch, double size_m, const Comparison& forward,
                       const Comparison& reverse) {
  constexpr double kAbout_m = 0.03;
  constexpr size_t kEnoughPoints = 100;
  const Vec3 d{-0.1, kAbout_m + size_m, -0.1};
  const Box3 box{patch.box.min - d, patch.box.max + d};
  bool can_be_told = true;
  for (const Comparison* comparison : {&forward, &reverse}) {
    const auto level = comparison->points.require("level_of_detection").values<float>();
    size_t points = 0, fine = 0;
    for (size_t i = 0; i < level.size(); ++i) {
      if (!box.contains(in_street(comparison->cloud->point(i)))) continue;
      ++points;
      fine += level[i] < size_m ? 1 : 0;  // false for NaN
    }
    can_be_told = can_be_told && points >= kEnoughPoints && 2 * fine >= points;
  }
  return can_be_told;
}

}  // namespace

TEST_CASE("street__each_change_that_was_seen_is_found_once_with_its_class_by_default") {
  StreetTally tally;
  const double step_rad = is_full() ? 0.003 : 0.005;
  const SeedRange seeds =
      seeds_asked_for("JALON_CHANGE_SEEDS").value_or(SeedRange{501, is_full() ? 520u : 501u});
  for (uint64_t seed = seeds.first; seed <= seeds.last; ++seed) {
    const CloudPtr before = scanned_street(1, step_rad, 2 * seed),
                   after = scanned_street(2, step_rad, 2 * seed + 1);
    const Comparison forward = detected(before, after), reverse = detected(after, before);
    CHECK(forward.summary.require("stations").values<uint64_t>()[0] == 2);
    score(diagnosed(forward, reverse), tally);
  }
  report("street, two epochs without stations", tally);
  CHECK(tally.right == planted().size() * tally.runs);
  CHECK(tally.wrong_class == 0);
  CHECK(tally.pieces == 0);
  CHECK(tally.most_invented <= 1);
}

// Seeds 521 to 560 were looked at before. The patches are asked for where their size exceeds their level of detection;
// what came and went does so everywhere.
TEST_CASE("street__from_three_stations_of_unlike_density_what_exceeds_its_detection_is_found") {
  constexpr std::array<double, 7> kSize_m{0.02, 0.1, 0.02, 0.005, 1.5, 6, 1.4};
  constexpr size_t kPatches = 4;
  constexpr double kFinest_rad = 0.003;  // at 0.005 things are told in two pieces in one run of ten
  StreetTally tally;
  size_t asked = 0, found_once = 0, not_asked = 0;
  const SeedRange seeds =
      seeds_asked_for("JALON_CHANGE_SEEDS").value_or(SeedRange{561, is_full() ? 580u : 561u});
  for (uint64_t seed = seeds.first; seed <= seeds.last; ++seed) {
    const CloudPtr before = scanned_unevenly(1, kFinest_rad, 2 * seed),
                   after = scanned_unevenly(2, kFinest_rad, 2 * seed + 1);
    const Comparison forward = detected(before, after), reverse = detected(after, before);
    CHECK(forward.summary.require("stations").values<uint64_t>()[0] == 3);
    const auto times = score(diagnosed(forward, reverse), tally);
    for (size_t k = 0; k < times.size(); ++k) {
      const bool is_asked =
          k >= kPatches || exceeds_detection(planted()[k], kSize_m[k], forward, reverse);
      ++(is_asked ? asked : not_asked);
      found_once += is_asked && times[k] == 1 ? 1 : 0;
      if (!is_asked) MESSAGE(std::string(planted()[k].name) << " is below its level of detection");
    }
  }
  report("street, three stations, densities 1 : 10", tally);
  MESSAGE("FIGURE   exceed their level of detection: " << asked << ", of these found once "
                                                       << found_once << "; do not: " << not_asked);
  CHECK(found_once == asked);
  CHECK(tally.wrong_class == 0);
  CHECK(tally.most_invented <= 1);
}

TEST_CASE("street__the_same_scene_scanned_twice_has_no_change") {
  StreetTally tally;
  for (uint64_t seed = 601; seed <= (is_full() ? 620u : 601u); ++seed) {
    const CloudPtr before = scanned_street(1, 0.006, 2 * seed),
                   after = scanned_street(1, 0.006, 2 * seed + 1);
    score(diagnosed(detected(before, after), detected(after, before)), tally);
  }
  report("street, unchanged", tally);
  CHECK(tally.right + tally.wrong_class + tally.pieces == 0);
  CHECK(tally.invented == 0);
}

// Each of the four stations with an error of its own, as registrations leave: 5 mm and 0.2 mrad, 1 cm at the far end of
// the street together. The patches of 5 and 20 mm lie below that and may be found or not. Seeds 701 to 720 were
// developed on.
TEST_CASE("street__between_stations_that_are_registered_badly_what_is_larger_is_a_change") {
  const std::string misfit = ", \"misfit_shift_m\": 0.005, \"misfit_rotation_rad\": 0.0002";
  constexpr std::array<size_t, 4> kLarge{1, 4, 5, 6};
  size_t runs = 0, found_once = 0, invented = 0;
  const SeedRange seeds =
      seeds_asked_for("JALON_CHANGE_SEEDS").value_or(SeedRange{721, is_full() ? 740u : 721u});
  for (uint64_t seed = seeds.first; seed <= seeds.last; ++seed, ++runs) {
    const CloudPtr before = scanned_street(1, 0.005, 2 * seed, misfit),
                   after = scanned_street(2, 0.005, 2 * seed + 1, misfit);
    StreetTally tally;
    const auto times = score(diagnosed(detected(before, after), detected(after, before)), tally);
    for (const size_t k : kLarge) found_once += times[k] == 1 ? 1 : 0;
    invented += tally.invented;
  }
  MESSAGE(
      "FIGURE street, stations with errors of 5 mm and 0.2 mrad: of four changes larger than them "
      << found_once << " of " << kLarge.size() * runs << " found once, " << invented
      << " invented in " << runs << " runs");
  CHECK(static_cast<double>(found_once) >= 0.95 * static_cast<double>(kLarge.size() * runs));
  CHECK(invented <= runs / 4);
}

}  // namespace jalon::street_changes_test
