// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/visibility/recovery.h"

#include <doctest/doctest.h>

#include <cmath>

#include "base/error.h"
#include "compare/distance/distance.h"
#include "unit/compare/lattice.h"

using namespace jalon;
using namespace jalon::test;

namespace {

using Way = HiddenSettings::Way;

DistanceSettings seen_by_stations(Way hidden = Way::kLeave) {
  DistanceSettings settings;
  settings.visibility = DistanceSettings::VisibleFrom::kStations;
  settings.hidden.way = hidden;
  return settings;
}

Comparison compared(const Cloud& reference, const Cloud& cloud, const DistanceSettings& settings) {
  Task task;
  return compare_distance(std::make_shared<const Cloud>(reference),
                          std::make_shared<const Cloud>(cloud), settings, task);
}

double number(const FieldTable& table, const char* column, size_t row = 0) {
  return table.require(column).number(row);
}

/// Ground 2 m below the scanner.
auto ground(double depth_m) {
  return [depth_m](const Vec3& d) { return d.z < 0 ? -depth_m / d.z : 0; };
}
const Look kDown{-0.6, 0.6, -0.8, -0.12, 0.005, 0.005, 0};

/// The ground with a hole of 2 x 2 x 1 m.
double ground_with_pit(const Vec3& d) {
  if (!(d.z < 0)) return 0;
  const auto at = [&](double depth_m) { return d * (-depth_m / d.z); };
  const auto inside = [](const Vec3& p) { return std::abs(p.x) < 1 && std::abs(p.y - 6) < 1; };
  if (!inside(at(2))) return norm(at(2));
  if (inside(at(3))) return norm(at(3));
  return d.y > 0 ? 7 / d.y : 0;  // its back
}

/// A wall with waves, this much farther.
auto waved_wall(double recess_m) {
  return [recess_m](const Vec3& d) {
    double r = 10;
    for (int i = 0; i < 50; ++i)
      r = (10 + recess_m + 0.3 * std::sin(4 * d.x * r) * std::cos(3 * d.z * r)) / d.y;
    return r;
  };
}

}  // namespace

TEST_CASE("recovery__a_pit_is_hidden_and_recovered_by_its_depth") {
  const Cloud before = lattice(kDown, {}, ground(2)), after = lattice(kDown, {}, ground_with_pit);
  const Comparison left = compared(before, after, seen_by_stations());
  const Comparison made = compared(before, after, seen_by_stations(Way::kVertical));
  size_t deep = 0, hidden = 0, recovered = 0;
  double worst = 0;
  for (size_t i = 0; i < after.size(); ++i) {
    if (after.point(i).z > -2.3) continue;
    ++deep;
    hidden +=
        number(left.points, "status", i) == 1 && std::isnan(number(left.points, "distance", i));
    if (number(made.points, "recovered", i) != 1) continue;
    ++recovered;
    CHECK(number(made.points, "status", i) == 0);
    worst = std::max(worst, std::abs(number(made.points, "height", i) - (after.point(i).z + 2)));
    CHECK(number(made.points, "distance", i) == std::abs(number(made.points, "height", i)));
  }
  REQUIRE(deep > 800);
  CHECK(hidden == deep);
  CHECK(recovered == deep);
  CHECK(worst < 1e-9);
  CHECK(number(made.summary, "hidden") + static_cast<double>(deep) <=
        number(left.summary, "hidden"));
}

TEST_CASE("recovery__heights_follow_any_direction_and_leave_what_has_no_surface") {
  Task task;
  const Cloud wall = lattice({}, {}, wall_at(10));
  std::vector<double> xyz{0.3, 10.7, 0.2, -1, 9.5, 1, 30, 10.7, 0};
  Buffer<double> buffer(9);
  std::copy(xyz.begin(), xyz.end(), buffer.data());
  const Cloud points = make_cloud(std::move(buffer));
  const uint64_t all[] = {0, 1, 2};
  const auto heights = heights_along(wall, points, all, {0, 1, 0}, 2, task);
  CHECK(heights[0] == doctest::Approx(0.7));
  CHECK(heights[1] == doctest::Approx(-0.5));
  CHECK(std::isnan(heights[2]));
  // Points 0.1 m apart have no triangles within 5 cm.
  CHECK(std::isnan(heights_along(wall, points, all, {0, 1, 0}, 0.05, task)[0]));
  CHECK(heights_along(wall, points, {}, {0, 0, 1}, 2, task).empty());
  CHECK(std::isnan(heights_along(Cloud{}, points, all, {0, 0, 1}, 2, task)[0]));
}

TEST_CASE("recovery__a_receded_surface_has_the_shape_of_what_hides_it_and_a_floor_has_not") {
  const Look look{-0.3, 0.3, -0.2, 0.3, 0.005, 0.005, 0};
  const Cloud before = lattice(look, {}, waved_wall(0));
  // The wall stands half a metre back.
  const DistanceSettings settings = seen_by_stations(Way::kOccluders);
  const Comparison moved = compared(before, lattice(look, {}, waved_wall(0.5)), settings);
  size_t recovered = 0, hidden = 0;
  double sum = 0;
  for (size_t i = 0; i < moved.cloud->size(); ++i) {
    hidden += number(moved.points, "status", i) == 1;
    if (number(moved.points, "recovered", i) != 2) continue;
    ++recovered;
    sum += number(moved.points, "distance", i);
  }
  MESSAGE("FIGURE receded wall: recovered " << recovered << ", hidden still " << hidden
                                            << ", mean distance "
                                            << sum / static_cast<double>(recovered));
  CHECK(recovered > 20 * hidden);
  CHECK(sum / static_cast<double>(recovered) == doctest::Approx(0.45).epsilon(0.15).scale(0));
  // The wall is gone and shows a floor behind it.
  const auto floor = [](const Vec3& d) { return d.z < -0.06 ? -1.5 / d.z : 0; };
  const Comparison gone = compared(before, lattice(look, {}, floor), settings);
  hidden = recovered = 0;
  for (size_t i = 0; i < gone.cloud->size(); ++i) {
    hidden += number(gone.points, "status", i) == 1;
    recovered += number(gone.points, "recovered", i) == 2;
  }
  CHECK(hidden > 100);
  CHECK(recovered * 20 < hidden);
}

TEST_CASE("recovery__a_removed_screen_makes_no_change_behind_it") {
  const auto screen = [](const Vec3& d) {
    return d.y > 0 && std::abs(d.x / d.y) < 0.2 && std::abs(d.z / d.y) < 0.15 ? 3 / d.y
                                                                              : wall_at(10)(d);
  };
  Look look;
  look.angle_noise = 1e-4;
  const Cloud before = lattice(look, {}, screen), after = lattice(look, {}, wall_at(10));
  const Comparison all = compared(before, after, {}),
                   seen = compared(before, after, seen_by_stations());
  size_t false_all = 0, false_seen = 0;
  for (size_t i = 0; i < after.size(); ++i) {
    false_all += number(all.points, "distance", i) > 0.3;
    false_seen += number(seen.points, "distance", i) > 0.3;
  }
  MESSAGE("FIGURE changes behind a removed wall: " << false_all << " blind, " << false_seen
                                                   << " with visibility");
  CHECK(false_all > 500);
  CHECK(false_seen == 0);
}

TEST_CASE("recovery__all_hidden_is_a_result") {
  const Cloud before = lattice({}, {}, wall_at(5)), after = lattice({}, {}, wall_at(10));
  const Comparison made = compared(before, after, seen_by_stations());
  CHECK(number(made.summary, "hidden") == static_cast<double>(after.size()));
  CHECK(number(made.summary, "compared") == 0);
  CHECK(std::isnan(number(made.summary, "mean")));
  CHECK(std::isnan(number(made.points, "distance", 7)));
  DistanceSettings nowhere = seen_by_stations();
  nowhere.hidden.direction = {0, 0, 0};
  CHECK_THROWS_AS(compared(before, after, nowhere), Error);
}

TEST_CASE("recovery__a_third_epoch_tells_what_probably_did_not_move") {
  // Epoch t has a screen before the wall; behind it a patch of the wall moves between the epochs before and after.
  const auto screen = [](const Vec3& d) {
    return std::abs(d.x / d.y) < 0.2 ? 3 / d.y : wall_at(10)(d);
  };
  const auto moved = [](const Vec3& d) {
    return std::abs(d.x / d.y) < 0.1 && d.z > 0 ? 9.5 / d.y : wall_at(10)(d);
  };
  const Cloud before = lattice({}, {}, wall_at(10)), now = lattice({}, {}, screen),
              later = lattice({}, {}, moved);
  const Comparison hidden = compared(now, before, seen_by_stations());
  const Comparison across = compared(later, before, {});
  Task task;
  const Comparison made = with_third_epoch(hidden, across, 0.1, task);
  size_t same = 0, changed = 0, wrong = 0;
  for (size_t i = 0; i < before.size(); ++i) {
    const double how = number(made.points, "recovered", i);
    if (number(hidden.points, "status", i) != 1) {
      wrong += how != 0;
      continue;
    }
    const Vec3 p = before.point(i);
    const bool has_moved = std::abs(p.x) < 0.95 && p.z > 0.05,
               is_near = std::abs(p.x) < 1.1 && p.z > -0.1;
    same += how == 3;
    changed += how == 4;
    if (has_moved) wrong += how != 4;
    if (!is_near) wrong += how != 3;
    CHECK(std::isnan(number(made.points, "distance", i)));
  }
  CHECK(same > 500);
  CHECK(changed > 300);
  CHECK(wrong == 0);
  CHECK_THROWS_AS(with_third_epoch(hidden, compared(now, later, {}), 0.1, task), Error);
  CHECK_THROWS_AS(with_third_epoch(hidden, across, -1, task), Error);
}
