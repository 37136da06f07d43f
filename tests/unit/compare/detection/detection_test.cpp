// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/detection/detection.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstring>

#include "compare/distance/distance.h"
#include "unit/compare/detection/room_scan.h"

using namespace jalon;
using namespace jalon::test;

namespace {

Comparison detected(const CloudPtr& reference, const CloudPtr& compared, unsigned threads = 0) {
  Task task(Task::Hooks{.threads = threads});
  DistanceSettings settings;
  settings.detection = true;
  settings.visibility = DistanceSettings::VisibleFrom::kStations;
  return compare_distance(reference, compared, settings, task);
}

struct Found {
  size_t inside = 0, significant_inside = 0, significant_outside = 0;
};

// Significant points in a box and outside it.
template <class F>
Found found_in(const Comparison& made, F&& is_inside) {
  const auto significant = made.points.require("significant").values<uint8_t>();
  Found out;
  for (size_t i = 0; i < significant.size(); ++i) {
    const bool inside = is_inside(made.cloud->point(i));
    out.inside += inside ? 1 : 0;
    (inside ? out.significant_inside : out.significant_outside) += significant[i];
  }
  return out;
}

const std::vector<Vec3> kPlaces{{-2.5, 1, 1.6}, {2, -1.5, 1.75}};
const std::vector<Vec3> kOtherPlaces{{-1.5, -1, 1.5}, {1, 2.2, 1.7}};

bool is_on_panel(const Vec3& p) {
  return p.x > 4.8 && std::abs(p.y) <= 1.1 && p.z >= 0.4 && p.z <= 1.8;
}

}  // namespace

TEST_CASE("detection__the_same_room_from_other_places_has_no_change") {
  for (uint64_t seed = 11; seed <= 13; ++seed) {
    const Comparison made =
        detected(RoomScan{}.scan(kPlaces, 2 * seed), RoomScan{}.scan(kOtherPlaces, 2 * seed + 1));
    const Found found = found_in(made, [](const Vec3&) { return true; });
    CHECK(static_cast<double>(found.significant_inside) <=
          0.001 * static_cast<double>(found.inside));
  }
}

TEST_CASE("detection__a_panel_that_moved_by_four_times_the_noise_is_significant_and_nothing_else") {
  RoomScan after;
  after.panel_m = 0.008;
  const Comparison made = detected(RoomScan{}.scan(kPlaces, 21), after.scan(kOtherPlaces, 22));
  const Found found = found_in(made, is_on_panel);
  CHECK(static_cast<double>(found.significant_inside) > 0.6 * static_cast<double>(found.inside));
  CHECK(static_cast<double>(found.significant_outside) <=
        0.001 * static_cast<double>(made.cloud->size()));
}

TEST_CASE("detection__an_alignment_known_no_better_hides_that_panel") {
  RoomScan after;
  after.panel_m = 0.008;
  Task task;
  DistanceSettings settings;
  settings.detection = true;
  settings.visibility = DistanceSettings::VisibleFrom::kStations;
  settings.alignment_sigma_m = 0.01;
  const Comparison made =
      compare_distance(RoomScan{}.scan(kPlaces, 21), after.scan(kOtherPlaces, 22), settings, task);
  CHECK(found_in(made, is_on_panel).significant_inside == 0);
}

TEST_CASE("detection__a_box_is_seen_through_before_it_came_and_its_shadow_is_no_change") {
  RoomScan with;
  with.has_box = true;
  const CloudPtr before = RoomScan{}.scan(kPlaces, 31), after = with.scan(kPlaces, 32);
  const auto is_box = [](const Vec3& p) {
    return p.x > 2.5 && p.x < 3.5 && p.y > 0.5 && p.y < 1.5 && p.z < 1.1;
  };
  const Comparison forward = detected(before, after), reverse = detected(after, before);
  const Found came = found_in(forward, is_box), went = found_in(reverse, is_box);
  CHECK(static_cast<double>(came.significant_inside) > 0.6 * static_cast<double>(came.inside));
  CHECK(came.significant_outside < 50);
  // The floor under it and the wall behind it were seen before and are hidden now.
  CHECK(went.significant_inside + went.significant_outside < 50);
  const auto status = reverse.points.require("status").values<uint8_t>();
  CHECK(std::count(status.begin(), status.end(), static_cast<uint8_t>(CompareStatus::kHidden)) >
        100);
}

TEST_CASE("detection__any_number_of_threads_gives_the_same_bits") {
  RoomScan after;
  after.panel_m = 0.01;
  after.step_rad = 0.016;
  const CloudPtr from = after.scan(kPlaces, 41), to = after.scan(kOtherPlaces, 42);
  const Comparison one = detected(from, to, 1), four = detected(from, to, 4);
  for (const char* name : {"distance", "level_of_detection", "significant", "evidence", "status"}) {
    const Column &a = one.points.require(name), &b = four.points.require(name);
    CHECK(std::memcmp(a.raw(), b.raw(), a.bytes()) == 0);
  }
}
