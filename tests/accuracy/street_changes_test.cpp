// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// The street's two epochs as files without stations hold them, by what the command line does by default: each of the
// changes once, with its class, and hardly anything else. Of the scene's eight the first patch, of 5 mm, lies behind a
// box: both stations together have a handful of points on it, and nothing can be told.
#include <doctest/doctest.h>

#include <array>

#include "compare/changes/diagnosis.h"
#include "compare/detection/found_stations.h"
#include "compare/distance/distance.h"
#include "recipe.h"
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

Vec3 place_of(const Diagnosis& found, const Change& change) {
  Vec3 sum;
  for (const uint32_t i : change.object.before) sum += found.before.cloud().point(i);
  for (const uint32_t i : change.object.after) sum += found.after.cloud().point(i);
  const Vec3 p =
      sum / static_cast<double>(change.object.before.size() + change.object.after.size());
  const double c = std::cos(kTurn_rad), s = std::sin(kTurn_rad);
  return {c * p.x + s * p.y, -s * p.x + c * p.y, p.z};
}

struct StreetTally {
  size_t runs = 0, right = 0, wrong_class = 0, pieces = 0, invented = 0, most_invented = 0;
};

/// How often each planted change was found.
std::array<int, 7> score(const Diagnosis& found, StreetTally& tally) {
  constexpr double kMargin_m = 0.3;
  std::array<int, 7> times{};
  size_t invented = 0;
  for (const Change& change : found.changes) {
    const Vec3 p = place_of(found, change);
    bool is_planted = false;
    for (size_t k = 0; k < planted().size(); ++k) {
      const Box3& box = planted()[k].box;
      const Vec3 d{kMargin_m, kMargin_m, kMargin_m};
      if (!Box3{box.min - d, box.max + d}.contains(p)) continue;
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
