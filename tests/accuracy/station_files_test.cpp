// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Stations through files: two epochs of one scene, each from two stations of its own, written and read again. What the
// files tell of the stations is enough that no shadow is a change.
#include <doctest/doctest.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "change_scenes.h"
#include "compare/changes/diagnosis.h"
#include "compare/changes/moved_things.h"
#include "compare/distance/distance.h"
#include "formats/formats.h"
#include "recipe.h"

namespace jalon::station_files_test {

using namespace jalon::test;

namespace {

TriangleScene yard(uint64_t seed) {
  TriangleScene scene;
  scene.ground(9);
  scene.quad({-9, 9, 0}, {9, 9, 0}, {9, 9, 4}, {-9, 9, 4}, 2);
  RandomStream random(seed, 31);
  for (uint32_t k = 0; k < 5; ++k) {
    const double turned_deg = 90 * random.uniform(), y = 10 * (random.uniform() - 0.5),
                 x = 10 * (random.uniform() - 0.5);
    const Vec3 size{0.5 + 1.5 * random.uniform(), 0.5 + random.uniform(), 0.4 + random.uniform()};
    scene.box(size, placed(x, y, turned_deg), 3 + k);
  }
  return scene;
}

// Through a file of this name and back.
CloudPtr from_file(const CloudPtr& cloud, const std::string& extension) {
  std::string folder = (std::filesystem::temp_directory_path() / "jalon-stations-XXXXXX").string();
  REQUIRE(::mkdtemp(folder.data()) != nullptr);
  Task task;
  Cloud bare = *cloud;
  bare.fields = {};
  write_cloud(bare, folder + "/scan" + extension, {}, task);
  auto back = std::make_shared<const Cloud>(read_cloud(folder + "/scan" + extension, {}, task));
  for (const std::string& name : {"/scan" + extension, std::string("/scan.stations.json")})
    std::remove((folder + name).c_str());
  std::remove(folder.c_str());
  return back;
}

Comparison compared(const CloudPtr& reference, const CloudPtr& cloud,
                    DistanceSettings::VisibleFrom from) {
  Task task;
  DistanceSettings settings;
  settings.detection = true;
  settings.visibility = from;
  return compare_distance(reference, cloud, settings, task);
}

// Of the compared points, those that the other epoch's stations could not see.
size_t hidden_points(const Comparison& comparison) {
  const auto status = comparison.points.require("status").values<uint8_t>();
  return static_cast<size_t>(
      std::count(status.begin(), status.end(), static_cast<uint8_t>(CompareStatus::kHidden)));
}

struct Found {
  size_t changes = 0;
  size_t hidden = 0;
};

Found found_between(const CloudPtr& before, const CloudPtr& after,
                    DistanceSettings::VisibleFrom from) {
  Task task;
  const Comparison forward = compared(before, after, from), reverse = compared(after, before, from);
  return {diagnose(forward, reverse, {}, task).changes.size(), hidden_points(forward)};
}

}  // namespace

TEST_CASE("station_files__no_shadow_is_a_change_when_the_files_tell_the_stations") {
  for (const std::string kind : {".e57", ".las", ".xyz"}) {
    size_t runs = 0, quiet = 0, shadowed = 0, without = 0;
    for (uint64_t seed = 801; seed <= (is_full() ? 820u : 801u); ++seed, ++runs) {
      const TriangleScene scene = yard(seed);
      const ScanSetting coarse{0.008, 0.003};
      const CloudPtr before =
          from_file(scanned(scene, stations_around(2, 7, 1.8, 10), 2 * seed, coarse), kind);
      const CloudPtr after =
          from_file(scanned(scene, stations_around(2, 7, 1.6, 100), 2 * seed + 1, coarse), kind);
      REQUIRE(before->stations.size() == 2);
      using From = DistanceSettings::VisibleFrom;
      const Found told = found_between(before, after, From::kStations);
      quiet += told.changes == 0 ? 1 : 0;
      shadowed += told.hidden >= kLeastToldPoints ? 1 : 0;
      without += found_between(before, after, From::kAnywhere).changes > 0 ? 1 : 0;
    }
    MESSAGE("FIGURE stations through files " << kind << ": no change in " << quiet << " of " << runs
                                             << " pairs, shadows in " << shadowed
                                             << "; told nothing, some in " << without);
    CHECK(quiet == runs);
    CHECK(shadowed == runs);
  }
}

}  // namespace jalon::station_files_test
