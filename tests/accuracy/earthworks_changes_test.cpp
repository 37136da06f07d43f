// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include "compare/recovery.h"
#include "earthworks.h"

// What the comparer makes of the days of earthworks: octree-and-applications 9, (8) and (9).

using namespace jalon;
using namespace jalon::test;

namespace {

ParamSet seen_by_stations(std::vector<std::pair<const char*, const char*>> texts = {}) {
  ParamSet params("comparer distance", distance_rows());
  params.set_text("visibility", "stations");
  for (const auto& [name, value] : texts) params.set_text(name, value);
  return params;
}

Comparison compared(int reference, int day, const ParamSet& params) {
  Task task;
  return compare_distance(site_days()[static_cast<size_t>(reference - 1)].cloud,
                          site_days()[static_cast<size_t>(day - 1)].cloud, params, task);
}

uint32_t face_of(const Comparison& comparison, size_t i) { return values<uint32_t>(*comparison.cloud, "face")[i]; }
double number(const Comparison& comparison, const char* column, size_t i) {
  return comparison.points.require(column).number(i);
}

/// The ground of day 1 and 2 away from the heap.
double old_ground_m(const Vec3& p) {
  const double turn = 2 * std::numbers::pi;
  return 0.3 * std::sin(turn * p.x / 27 + 0.7) + 0.2 * std::cos(turn * p.y / 19);
}

}  // namespace

TEST_CASE("earthworks__the_pit_is_hidden_by_the_filter_and_recovered_along_the_vertical") {
  const Comparison left = compared(2, 3, seen_by_stations());
  const Comparison made = compared(2, 3, seen_by_stations({{"hidden", "vertical"}}));
  size_t deep = 0, hidden = 0, recovered = 0;
  double squares = 0;
  for (size_t i = 0; i < made.cloud->size(); ++i) {
    const Vec3 p = true_point(*made.cloud, i);
    const double depth = old_ground_m(p) - p.z;
    if (face_of(made, i) != kPit || depth < 0.3) continue;
    ++deep;
    hidden += number(left, "status", i) == 1;
    if (number(made, "recovered", i) != 1) continue;
    ++recovered;
    const double error = number(made, "height", i) + depth;
    squares += error * error;
  }
  const double rms = std::sqrt(squares / static_cast<double>(recovered));
  MESSAGE("FIGURE pit: of " << deep << " points deeper than 0.3 m " << hidden << " are hidden, " << recovered
                            << " recovered with an error of " << 1000 * rms << " mm");
  REQUIRE(deep > 1000);
  CHECK(hidden >= deep * 95 / 100);
  CHECK(recovered >= hidden * 95 / 100);
  CHECK(rms < 0.03);
}

TEST_CASE("earthworks__behind_the_wall_that_is_gone_nothing_has_changed") {
  const SiteDay& before = site_days()[2];
  ParamSet blind("comparer distance", distance_rows());
  const Comparison all = compared(3, 4, blind), seen = compared(3, 4, seen_by_stations());
  // In the wall's shadow: a ray from day 3's scanner meets it more than a metre before the point.
  size_t shadow = 0, false_all = 0, false_seen = 0;
  for (size_t i = 0; i < seen.cloud->size(); ++i) {
    const Vec3 p = true_point(*seen.cloud, i);
    RayHit hit;
    const Vec3 eye = before.pose.translation();
    if (!before.is_in_field(p) || !before.tree->nearest({eye, p - eye}, hit)) continue;
    if ((1 - hit.t) * norm(p - eye) < 1) continue;
    if (before.face(hit.triangle) < kFreeWall || before.face(hit.triangle) >= kExcavator) continue;
    ++shadow;
    false_all += number(all, "distance", i) > 0.5;
    false_seen += number(seen, "distance", i) > 0.5;
  }
  MESSAGE("FIGURE behind the removed wall: " << shadow << " points, changed " << false_all << " without, " << false_seen
                                             << " with visibility");
  CHECK(shadow > 1000);
  CHECK(false_all > 1000);
  CHECK(false_seen == 0);
}
