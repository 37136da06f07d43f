// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include "base/numbers.h"
#include "compare/landslide/moved_zones.h"
#include "slope_fixture.h"

using namespace jalon;
using namespace jalon::test;

namespace {

/// Noise of 5 mm, and two boxes that moved, side by side.
GroundChange two_boxes(const VolumeGrid& grid, double down_m, double up_m) {
  RandomStream random(4, 1);
  GroundChange out{std::vector<double>(grid.cells(), 0.0),
                   std::vector<double>(grid.cells(), 0.005)};
  for (size_t cell = 0; cell < grid.cells(); ++cell) {
    const size_t c = cell % grid.columns, r = cell / grid.columns;
    out.difference[cell] = 0.005 * random.normal();
    if (r >= 20 && r < 30 && c >= 20 && c < 30) out.difference[cell] -= down_m;
    if (r >= 20 && r < 30 && c >= 30 && c < 36) out.difference[cell] += up_m;
  }
  return out;
}

}  // namespace

TEST_CASE("moved_zones__are_of_one_sign_and_the_larger_one_first") {
  Task task;
  const VolumeGrid grid = plain_grid(60, 50);
  const MovedZones found = moved_zones(grid, two_boxes(grid, 0.1, 0.1), {}, task);
  REQUIRE(found.count == 2);
  size_t first = 0, second = 0, astray = 0;
  for (size_t cell = 0; cell < grid.cells(); ++cell) {
    const size_t c = cell % grid.columns, r = cell / grid.columns;
    const bool row = r >= 20 && r < 30;
    if (found.labels[cell] == 1) (row && c >= 20 && c < 30 ? first : astray) += 1;
    if (found.labels[cell] == 2) (row && c >= 30 && c < 36 ? second : astray) += 1;
  }
  CHECK(first >= 98);
  CHECK(second >= 58);
  CHECK(astray <= 2);
}

TEST_CASE("moved_zones__see_what_only_many_cells_together_show") {
  Task task;
  const VolumeGrid grid = plain_grid(60, 50);
  const MovedZones found =
      moved_zones(grid, two_boxes(grid, 0.012, 0), {}, task);  // 2.4 sigma a cell
  REQUIRE(found.count == 1);
  LandslideSettings settings;
  settings.min_area_m2 = 120;
  CHECK(moved_zones(grid, two_boxes(grid, 0.012, 0), settings, task).count == 0);
  settings = {};
  settings.alignment_sigma_m = 0.01;
  CHECK(moved_zones(grid, two_boxes(grid, 0.012, 0), settings, task).count == 0);
}

TEST_CASE("moved_zones__of_cells_without_measurements_are_none") {
  Task task;
  const VolumeGrid grid = plain_grid(20, 20);
  const GroundChange none{std::vector<double>(grid.cells(), kNaN),
                          std::vector<double>(grid.cells(), kNaN)};
  CHECK(moved_zones(grid, none, {}, task).count == 0);
}
