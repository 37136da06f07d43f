// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include "compare/changes/regions.h"
#include "compare/distance/distance.h"
#include "compare/visibility/recovery.h"
#include "earthworks.h"

// What the comparer makes of the days of earthworks: what a removed wall uncovers is hidden, a pit is found.

namespace jalon::earthworks_changes_test {

using namespace jalon::test;

namespace {

DistanceSettings seen_by_stations() {
  DistanceSettings settings;
  settings.visibility = DistanceSettings::VisibleFrom::kStations;
  return settings;
}

/// With planes through 32 points of the reference.
DistanceSettings with_planes() {
  DistanceSettings settings = seen_by_stations();
  settings.local_model = LocalModelKind::kPlane;
  settings.k = 32;
  return settings;
}

Comparison compared(int reference, int day, const DistanceSettings& settings) {
  Task task;
  return compare_distance(site_days()[static_cast<size_t>(reference - 1)].cloud,
                          site_days()[static_cast<size_t>(day - 1)].cloud, settings, task);
}

uint32_t face_of(const Comparison& comparison, size_t i) {
  return values<uint32_t>(*comparison.cloud, "face")[i];
}
double number(const Comparison& comparison, const char* column, size_t i) {
  return comparison.points.require(column).number(i);
}

/// Something that is there on the compared day and not on the reference's.
struct Planted {
  const char* name;
  bool (*is_new)(int reference, int day);
  bool (*holds)(uint32_t face, const Vec3& p);
};
bool is_in_pit(const Vec3& p) { return p.x > 33.7 && p.x < 42.3 && p.y > 11.7 && p.y < 17.3; }
constexpr Planted kPlanted[] = {
    {"heap", [](int r, int c) { return r == 1 && c > 1; },
     [](uint32_t f, const Vec3&) { return f == kHeap; }},
    // What was there before the pit hangs in the air above it.
    {"earth of the pit", [](int r, int c) { return r > 2 && c < 3; },
     [](uint32_t f, const Vec3& p) { return f == kGround && is_in_pit(p); }},
    {"free wall", [](int r, int c) { return r == 4 && c < 4; },
     [](uint32_t f, const Vec3&) { return f >= kFreeWall && f < kExcavator; }},
    {"excavator", [](int r, int c) { return c > 2 && r != c; },
     [](uint32_t f, const Vec3&) { return f >= kExcavator; }},
};

/// Points of a region that belong to it.
size_t share_of(const ChangeRegion& region, const Comparison& comparison, const Planted& planted) {
  size_t n = 0;
  for (const uint32_t i : region.indices)
    n += planted.holds(face_of(comparison, i), true_point(*comparison.cloud, i));
  return n;
}

/// Whether the reference's scanner sees depth break within three of its steps of a point: a jump of more than half a
/// metre to one side that the other side does not continue.
bool is_at_edge(const SiteDay& reference, const Vec3& p) {
  const Vec3 eye = reference.pose.translation(), to = p - eye;
  const Vec3 across = normalized(cross(to, {0, 0, 1})), up = normalized(cross(across, to));
  const auto range = [&](const Vec3& aside) {
    RayHit hit;
    const Vec3 d = normalized(to + aside * (norm(to) * 0.6 * kDegree_rad));
    return reference.tree->nearest({eye, d}, hit) ? hit.t : 1e9;
  };
  const double here = range({});
  for (const Vec3& side : {across, up, across + up, across - up}) {
    const double one = range(side), other = range(-side);
    const double bend = std::abs(1 / one + 1 / other - 2 / here),
                 slope = std::abs(1 / one - 1 / other);
    if (std::max(std::abs(one - here), std::abs(other - here)) > 0.5 && bend > 0.25 * slope)
      return true;
  }
  return false;
}

/// A region that is nothing planted: it must lie along an edge in depth. Prints it.
bool is_along_edge(const ChangeRegion& region, const Comparison& comparison,
                   const SiteDay& reference) {
  size_t at_edge = 0;
  for (const uint32_t i : region.indices)
    at_edge += is_at_edge(reference, true_point(*comparison.cloud, i));
  MESSAGE("FIGURE false region of " << region.indices.size() << " points at (" << region.centroid.x
                                    << ", " << region.centroid.y << ", " << region.centroid.z
                                    << "), mean distance " << region.mean_m << " m, " << at_edge
                                    << " points at an edge in depth");
  return 2 * at_edge > region.indices.size();
}

/// The ground of day 1 and 2 away from the heap.
double old_ground_m(const Vec3& p) {
  const double turn = 2 * std::numbers::pi;
  return 0.3 * std::sin(turn * p.x / 27 + 0.7) + 0.2 * std::cos(turn * p.y / 19);
}

}  // namespace

TEST_CASE("earthworks__the_pit_is_hidden_by_the_filter_and_recovered_along_the_vertical") {
  const Comparison left = compared(2, 3, seen_by_stations());
  DistanceSettings settings = seen_by_stations();
  settings.hidden.way = HiddenSettings::Way::kVertical;
  const Comparison made = compared(2, 3, settings);
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
  MESSAGE("FIGURE pit: of " << deep << " points deeper than 0.3 m " << hidden << " are hidden, "
                            << recovered << " recovered with an error of " << 1000 * rms << " mm");
  REQUIRE(deep > 1000);
  CHECK(hidden >= deep * 95 / 100);
  CHECK(recovered >= hidden * 95 / 100);
  CHECK(rms < 0.03);
}

TEST_CASE("earthworks__behind_the_wall_that_is_gone_nothing_has_changed") {
  const SiteDay& before = site_days()[2];
  const Comparison all = compared(3, 4, {}), seen = compared(3, 4, seen_by_stations());
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
  MESSAGE("FIGURE behind the removed wall: " << shadow << " points, changed " << false_all
                                             << " without, " << false_seen << " with visibility");
  CHECK(shadow > 1000);
  CHECK(false_all > 1000);
  CHECK(false_seen == 0);
}

TEST_CASE("earthworks__every_planted_change_is_found_and_false_regions_lie_along_edges_in_depth") {
  DistanceSettings settings = with_planes();
  settings.reference_spacing = true;
  RegionSettings changed;
  changed.threshold_m = 0.15;
  changed.cell_m = 0.5;
  changed.min_points = 11;
  for (int reference = 1; reference <= 4; ++reference)
    for (int day = 1; day <= 4; ++day) {
      if (reference == day) continue;
      const Comparison comparison = compared(reference, day, settings);
      Task task;
      const ChangeRegions found = change_regions(comparison, changed, task);
      std::vector<bool> is_planted(found.regions.size(), false);
      for (const Planted& planted : kPlanted) {
        if (!planted.is_new(reference, day)) continue;
        size_t regions = 0, points = 0;
        for (size_t k = 0; k < found.regions.size(); ++k) {
          const size_t n = share_of(found.regions[k], comparison, planted);
          if (2 * n <= found.regions[k].indices.size()) continue;
          is_planted[k] = true;
          ++regions;
          points += n;
        }
        MESSAGE("FIGURE day " << day << " against day " << reference << ": "
                              << std::string(planted.name) << " in " << regions << " regions of "
                              << points << " points");
        CHECK(regions >= 1);
      }
      const SiteDay& before = site_days()[static_cast<size_t>(reference - 1)];
      for (size_t k = 0; k < found.regions.size(); ++k)
        if (!is_planted[k]) CHECK(is_along_edge(found.regions[k], comparison, before));
    }
}

TEST_CASE("earthworks__local_models_bring_the_static_ground_down_to_a_third") {
  for (const auto& [reference, day] : {std::pair{1, 2}, std::pair{2, 1}}) {
    const Comparison plain = compared(reference, day, seen_by_stations()),
                     modelled = compared(reference, day, with_planes());
    double squares = 0, modelled_squares = 0;
    size_t n = 0;
    for (size_t i = 0; i < plain.cloud->size(); ++i) {
      if (face_of(plain, i) != kGround || number(plain, "status", i) != 0) continue;
      const SiteDay& before = site_days()[static_cast<size_t>(reference - 1)];
      if (std::abs(before.depth_behind(true_point(*plain.cloud, i))) > 0.03)
        continue;  // the heap's place
      const double a = number(plain, "distance", i), b = number(modelled, "distance", i);
      squares += a * a;
      modelled_squares += b * b;
      ++n;
    }
    const double rms = std::sqrt(squares / static_cast<double>(n));
    const double modelled_rms = std::sqrt(modelled_squares / static_cast<double>(n));
    MESSAGE("FIGURE static ground, day "
            << day << " against day " << reference << ": " << 1000 * rms << " mm, "
            << 1000 * modelled_rms << " mm with local planes, a factor of " << rms / modelled_rms);
    CHECK(rms >= 3 * modelled_rms);
  }
}

}  // namespace jalon::earthworks_changes_test
