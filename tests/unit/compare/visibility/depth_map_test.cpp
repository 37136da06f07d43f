// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Range images: their cells against a loop over all points, the surface between them against the plane that was seen.
#include "compare/visibility/depth_map.h"

#include <doctest/doctest.h>

#include <cmath>

#include "base/error.h"
#include "unit/compare/lattice.h"

using namespace jalon;
using namespace jalon::test;

namespace {

DepthMap map_from(const Cloud& cloud, const DepthSettings& settings) {
  Task task;
  return DepthMap::build(cloud, cloud.stations[0], {}, settings, task);
}

AngularGrid::Place place_in(const DepthMap& map, const Vec3& direction) {
  AngularGrid::Place place;
  REQUIRE(map.grid().locate(map.sighting(direction), place));
  return place;
}

}  // namespace

TEST_CASE("depth_map__cells_keep_the_range_of_their_rule_and_the_nearest_point") {
  RandomStream random(61, 0);
  const Cloud cloud = lattice(
      {}, {}, [&](const Vec3&) { return random.uniform() < 0.3 ? 0 : 5 + random.uniform(); });
  for (const CellRule rule : {CellRule::kNearest, CellRule::kFarthest, CellRule::kMean}) {
    DepthSettings settings;
    settings.horizontal_step_rad = settings.vertical_step_rad =
        0.03;  // nine rays a cell, none on its border
    settings.cell_factor = 1;
    settings.fill_passes = 0;
    settings.rule = rule;
    const DepthMap map = map_from(cloud, settings);
    std::vector<std::vector<uint32_t>> members(map.grid().size());
    for (uint32_t i = 0; i < cloud.size(); ++i)
      members[map.grid().index(place_in(map, cloud.point(i)))].push_back(i);
    size_t several = 0;
    for (size_t c = 0; c < members.size(); ++c) {
      const auto column = static_cast<uint32_t>(c % map.grid().columns),
                 row = static_cast<uint32_t>(c / map.grid().columns);
      REQUIRE(map.count(column, row) == members[c].size());
      REQUIRE((map.fill(column, row) == DepthMap::Fill::kEmpty) == members[c].empty());
      if (members[c].empty()) continue;
      several += members[c].size() > 1;
      double low = 1e9, high = 0, sum = 0;
      uint32_t nearest = 0;
      for (const uint32_t i : members[c]) {
        const double range = norm(cloud.point(i));
        if (range < low) low = range, nearest = i;
        high = std::max(high, range);
        sum += range / static_cast<double>(members[c].size());
      }
      const double truth = rule == CellRule::kNearest ? low : rule == CellRule::kMean ? sum : high;
      REQUIRE(map.cell(column, row).range_m ==
              doctest::Approx(truth).epsilon(1e-6));  // single precision
      REQUIRE(map.cell(column, row).point == nearest);
    }
    CHECK(several > 500);
  }
}

TEST_CASE("depth_map__between_its_cells_a_wall_goes_on_as_a_plane") {
  const Cloud cloud = lattice({}, {}, wall_at(10));
  const DepthMap map = map_from(cloud, {});
  const double cell = map.grid().horizontal_step_rad;
  CHECK(cell == doctest::Approx(0.015).epsilon(0.02).scale(0));
  RandomStream random(62, 0);
  for (int k = 0; k < 2000; ++k) {
    const double aside = 0.94 * (random.uniform() - 0.5), up = 0.74 * (random.uniform() - 0.5);
    const Vec3 d = direction_of(aside, up);
    // Inverse range is linear up to the square of what lies between neighbours, at most 1.5 cells either way.
    REQUIRE(map.surface_range_m(place_in(map, d)) ==
            doctest::Approx(10 / d.y).epsilon(4 * cell * cell).scale(0));
  }
}

TEST_CASE("depth_map__spacing_is_that_along_the_wall_and_across_an_edge_in_depth") {
  const auto screen = [](const Vec3& d) { return std::abs(d.x / d.y) < 0.2 ? 3 / d.y : 10 / d.y; };
  const Cloud cloud = lattice({}, {}, screen);
  DepthSettings settings;
  settings.cell_factor = 1;
  const DepthMap map = map_from(cloud, settings);
  const auto spacing_at = [&](double h, double v) {
    return map.spacing_m(place_in(map, direction_of(h, v)));
  };
  const auto seen = [&](double h) { return direction_of(h, 0) * screen(direction_of(h, 0)); };
  CHECK(spacing_at(0, 0) == doctest::Approx(0.03).epsilon(0.02).scale(0));
  CHECK(spacing_at(0.3, 0) == doctest::Approx(norm(seen(0.31) - seen(0.3))).epsilon(0.02).scale(0));
  const double jump = norm(seen(0.2) - seen(0.19));
  CHECK(jump > 7);
  CHECK(spacing_at(0.19, 0) == doctest::Approx(jump).epsilon(0.01).scale(0));
  CHECK(spacing_at(0.2, 0) == doctest::Approx(jump).epsilon(0.01).scale(0));
  CHECK(spacing_at(0.17, 0) < 0.05);
}

TEST_CASE("depth_map__spacing_across_an_edge_in_depth_is_less_by_as_much_as_cells_are_wider") {
  const auto screen = [](const Vec3& d) { return std::abs(d.x / d.y) < 0.2 ? 3 / d.y : 10 / d.y; };
  const Cloud cloud = lattice({}, {}, screen);
  const auto seen = [&](double h) { return direction_of(h, 0) * screen(direction_of(h, 0)); };
  const double jump = norm(seen(0.2) - seen(0.19));
  for (const double factor : {1.0, DepthSettings{}.cell_factor, 2.0}) {
    CAPTURE(factor);
    DepthSettings settings;
    settings.cell_factor = factor;
    const DepthMap map = map_from(cloud, settings);
    const double spacing = map.spacing_m(place_in(map, direction_of(0.19, 0)));
    CHECK(spacing == doctest::Approx(jump / factor).epsilon(0.02).scale(0));
  }
}

// A stray point widens the field; the cells between it and the others hold nothing and cost nothing.
TEST_CASE("depth_map__a_point_far_aside_widens_the_grid_and_changes_no_other_cell") {
  Cloud cloud = lattice({}, {}, wall_at(10));
  const DepthMap alone = map_from(cloud, {});
  std::vector<double> xyz(cloud.xyz().begin(), cloud.xyz().end());
  for (const double c : {2e5, -1e6, 7e5}) xyz.push_back(c);  // behind and above
  Buffer<double> more(xyz.size());
  std::copy(xyz.begin(), xyz.end(), more.data());
  const auto stations = cloud.stations;
  cloud = make_cloud(std::move(more));
  cloud.stations = stations;
  ++cloud.stations[0].count;
  const DepthMap wide = map_from(cloud, {});
  CHECK(wide.grid().size() > 4 * alone.grid().size());
  CHECK(wide.tiles() < 2 * alone.tiles() + 10);
  RandomStream random(63, 0);
  size_t same = 0;
  for (int k = 0; k < 500; ++k) {
    const double aside = 0.9 * (random.uniform() - 0.5), up = 0.7 * (random.uniform() - 0.5);
    const Vec3 d = direction_of(aside, up);
    const double range = wide.surface_range_m(place_in(wide, d));
    same += std::abs(range - 10 / d.y) < 0.01;
  }
  CHECK(same > 490);
  AngularGrid::Place far;
  REQUIRE(wide.grid().locate(wide.sighting({2e5, -1e6, 7e5}), far));
  CHECK(wide.cell(far).point == cloud.size() - 1);
}

TEST_CASE("depth_map__of_nothing_is_empty_and_of_too_many_cells_is_refused") {
  Cloud cloud = lattice({}, {}, wall_at(10));
  DepthSettings fine;
  fine.horizontal_step_rad = fine.vertical_step_rad = 1e-7;
  try {
    map_from(cloud, fine);
    FAIL("made");
  } catch (const Error& error) {
    CHECK(error.status() == Status::kLimit);
    CHECK(std::string(error.what()).find("2^28") != std::string::npos);
  }
  cloud.stations[0].count = 0;
  const DepthMap none = map_from(cloud, {});
  CHECK(none.grid().size() == 0);
  AngularGrid::Place place;
  CHECK_FALSE(none.grid().locate({0, 0, 1}, place));
}
