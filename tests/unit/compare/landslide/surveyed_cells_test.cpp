// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include "compare/landslide/ground_grid.h"
#include "compare/landslide/surveyed_cells.h"
#include "slope_fixture.h"

using namespace jalon;
using namespace jalon::test;

namespace {

struct Surveyed {
  VolumeGrid grid;
  SurveyedCells cells;
};

Surveyed surveyed(const CloudPtr& before, const CloudPtr& after, LandslideSettings settings = {}) {
  Task task;
  settings.cell_m = 1;
  Surveyed out;
  out.grid = ground_grid(*before, *after, settings, task);
  const GroundHeights first = ground_heights(*before, out.grid, settings.min_points, task),
                      second = ground_heights(*after, out.grid, settings.min_points, task);
  out.cells = surveyed_cells(out.grid, first, second, before, after, settings, task);
  return out;
}

size_t count_inside(const Surveyed& s) {
  size_t n = 0;
  for (const uint8_t inside : s.cells.is_inside) n += inside;
  return n;
}

}  // namespace

TEST_CASE("surveyed_cells__enclosed_ones_without_points_are_inside_and_not_measured") {
  // A hole in both, and a corner that neither has: the hole is enclosed, the corner is not.
  const auto gap = [](double x, double y) {
    return (x > 10 && x < 16 && y > 10 && y < 14) || (x > 30 && y > 20);
  };
  const Surveyed s =
      surveyed(slope_survey(false, 1, 20000, gap), slope_survey(false, 2, 20000, gap));
  CHECK(std::abs(static_cast<double>(count_inside(s)) - (40 * 30 - 10 * 10)) <= 20);
  const size_t in_hole = 12 * size_t{s.grid.columns} + 13,
               in_corner = 25 * size_t{s.grid.columns} + 35;
  CHECK(s.cells.is_inside[in_hole] == 1);
  CHECK(s.cells.reference[in_hole] == CompareStatus::kNothingNear);
  CHECK(s.cells.compared[in_hole] == CompareStatus::kNothingNear);
  CHECK(s.cells.is_inside[in_corner] == 0);
  // The place of the hole is that of the ground around it.
  const Vec3 p = s.grid.place(in_hole, s.cells.place_m[in_hole]);
  CHECK(std::abs(p.z - slope_ground(p.x, p.y, false)) < 0.3);
}

TEST_CASE("surveyed_cells__an_outline_says_what_was_to_be_seen") {
  const auto gap = [](double x, double y) { return x > 30 && y > 20; };
  LandslideSettings settings;
  settings.outline = {0.2, 0.2, 100, 39.8, 0.2, 100, 39.8, 29.8, 109, 0.2, 29.8, 109};
  const Surveyed s =
      surveyed(slope_survey(false, 1, 20000, gap), slope_survey(false, 2, 20000, gap), settings);
  CHECK(count_inside(s) == 40 * 30);
  CHECK(s.cells.reference[25 * size_t{s.grid.columns} + 35] == CompareStatus::kNothingNear);
}

TEST_CASE("surveyed_cells__what_a_ridge_hides_from_the_station_is_hidden") {
  // Seen from y = -10: a wall of 3 m at y = 10 hides the ground behind it.
  std::vector<Vec3> points;
  const Vec3 eye{20, -10, 102};
  const double hidden_until =
      10 + 20 * 3.0 / 2.0;  // unbounded in truth: the wall is higher than the eye
  CHECK(hidden_until > 30);
  for (double azimuth = -0.6; azimuth < 0.6; azimuth += 0.004)
    for (double elevation = -0.15; elevation < 0.1; elevation += 0.004) {
      const double range_wall = 20 / std::cos(azimuth);
      const Vec3 wall = eye + Vec3{std::tan(azimuth) * 20, 20, range_wall * std::tan(elevation)};
      const double down = std::tan(elevation) < 0 ? 2 / -std::tan(elevation) : 1e9;
      const Vec3 ground = eye + Vec3{std::sin(azimuth) * down, std::cos(azimuth) * down, -2};
      if (down < range_wall) points.push_back(ground);
      else if (wall.z < 105) points.push_back(wall);
    }
  Cloud before = *cloud_of_points(points);
  Station station;
  station.has_pose = true;
  station.pose.m[3] = eye.x;
  station.pose.m[7] = eye.y;
  station.pose.m[11] = eye.z;
  station.count = before.size();
  before.stations = {station};
  RandomStream random(8, 1);
  std::vector<Vec3> all;
  for (int i = 0; i < 20000; ++i)
    all.push_back({12 + 16 * random.uniform(), 25 * random.uniform(), 100});
  const Surveyed s = surveyed(std::make_shared<const Cloud>(before), cloud_of_points(all));
  const Vec3 behind = s.grid.project({20, 18, 100});
  const size_t cell = s.grid.cell_of(behind);
  CHECK(s.cells.reference[cell] == CompareStatus::kHidden);
  CHECK(s.cells.compared[cell] == CompareStatus::kCompared);
}
