// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// The cooling tower of Girardeau-Montaut 2006, 5.3.2, from seven stations in both epochs, in the long run with the 12
// million points of its tables. Half of the shell is hidden from each station, and none of that is a change; where the
// shell gave way is one.
#include <doctest/doctest.h>

#include <cmath>

#include "change_scenes.h"
#include "diagnosed.h"
#include "recipe.h"

namespace jalon::tower_stations_test {

using namespace jalon::test;

namespace {

constexpr double kHeight_m = 180, kThroat_m = 35, kThroatAt_m = 135, kFlare_m = 90;
constexpr double kStationsAt_m = 150;
constexpr size_t kTowerStations = 7;
constexpr double kNoise_m = 0.01;
// A belly of the shell, before the second station.
constexpr double kBelly_m = 0.25, kBellyWide_m = 6, kBellyAt_m = 60;
constexpr double kBellyAngle = 2 * std::numbers::pi / kTowerStations;

double radius_at(double z) {
  const double flare = (z - kThroatAt_m) / kFlare_m;
  return kThroat_m * std::sqrt(1 + flare * flare);
}

TriangleScene shell(double belly_m) {
  constexpr int kAround = 480, kUp = 240;
  TriangleScene out;
  out.surface(kAround, kUp, 2, [&](double u, double t) {
    const double a = 2 * std::numbers::pi * u, z = kHeight_m * t, r = radius_at(z);
    const double along = r * std::remainder(a - kBellyAngle, 2 * std::numbers::pi),
                 up = z - kBellyAt_m;
    const double off =
        belly_m * std::exp(-(along * along + up * up) / (2 * kBellyWide_m * kBellyWide_m));
    return Vec3{(r + off) * std::cos(a), (r + off) * std::sin(a), z};
  });
  return out;
}

// Tripods that face the axis: they measure no more than the tower's width.
CloudPtr tower_scan(const TriangleScene& scene, double step_rad, uint64_t seed) {
  constexpr double kHalfWidth_rad = 0.5, kDown_rad = -0.1, kUp_rad = 1.1, kReach_m = 300;
  std::vector<ScanStation> stations;
  for (size_t k = 0; k < kTowerStations; ++k) {
    const double a_deg = 360.0 * static_cast<double>(k) / kTowerStations;
    ScanStation& s = stations.emplace_back();
    s.name = "station " + std::to_string(k + 1);
    const double a = a_deg * std::numbers::pi / 180;
    // The middle of its field of view is its y axis.
    s.pose = placed(kStationsAt_m * std::cos(a), kStationsAt_m * std::sin(a), a_deg + 90, 1.8);
  }
  Task task;
  const StaticSettings scanner{.horizontal_step_rad = step_rad,
                               .vertical_step_rad = step_rad,
                               .horizontal_from_rad = -kHalfWidth_rad,
                               .horizontal_to_rad = kHalfWidth_rad,
                               .vertical_from_rad = kDown_rad,
                               .vertical_to_rad = kUp_rad,
                               .max_range_m = kReach_m,
                               .range_noise_m = kNoise_m,
                               .seed = seed};
  return std::make_shared<const Cloud>(scan_static(scene.model(), stations, scanner, task));
}

Diagnosis changes_between(const CloudPtr& before, const CloudPtr& after) {
  return diagnosed(before, after, DistanceSettings::VisibleFrom::kStations);
}

}  // namespace

TEST_CASE("tower__from_seven_stations_has_its_belly_as_the_largest_change_and_no_shadow") {
  const double step_rad = is_full() ? 6.2e-4 : 8e-3;
  const CloudPtr before = tower_scan(shell(0), step_rad, 1),
                 again = tower_scan(shell(0), step_rad, 2),
                 bellied = tower_scan(shell(kBelly_m), step_rad, 3);
  const Diagnosis nothing = changes_between(before, again),
                  found = changes_between(before, bellied);
  MESSAGE("FIGURE tower of " << before->size() << " points from " << before->stations.size()
                             << " stations: " << nothing.changes.size()
                             << " changes where there is none, " << found.changes.size()
                             << " where it has a belly");
  CHECK(nothing.changes.empty());
  // Of the rate of false discoveries: of the many surfaces of a belly one in a hundred more may be found elsewhere.
  const auto largest = std::max_element(found.changes.begin(), found.changes.end(),
                                        [](const Change& a, const Change& b) {
                                          return a.object.after.size() < b.object.after.size();
                                        });
  REQUIRE(largest != found.changes.end());
  CHECK(largest->change_class == ChangeClass::kDeformationOverlap);
  Vec3 middle;
  for (const uint32_t i : largest->object.after)
    middle += bellied->point(i) / static_cast<double>(largest->object.after.size());
  const double r = radius_at(kBellyAt_m);
  const Vec3 belly{r * std::cos(kBellyAngle), r * std::sin(kBellyAngle), kBellyAt_m};
  CHECK(norm(middle - belly) < kBellyWide_m / 2);
}

}  // namespace jalon::tower_stations_test
