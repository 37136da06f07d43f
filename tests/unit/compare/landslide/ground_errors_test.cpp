// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include "base/numbers.h"
#include "compare/landslide/ground_errors.h"
#include "slope_fixture.h"

using namespace jalon;
using namespace jalon::test;

namespace {

/// Cells that differ by a scaled noise and by what all of them are off; every fifth has no measurement.
GroundChange resting_cells(const VolumeGrid& grid, double scale, double off_m) {
  RandomStream random(9, 1);
  GroundChange out{std::vector<double>(grid.cells(), kNaN),
                   std::vector<double>(grid.cells(), kNaN)};
  for (size_t cell = 0; cell < grid.cells(); ++cell) {
    if (cell % 5 == 0) continue;
    out.sigma[cell] = 0.002 + 0.004 * random.uniform();
    out.difference[cell] = off_m + scale * out.sigma[cell] * random.normal();
  }
  return out;
}

}  // namespace

TEST_CASE("ground_errors__tell_scale_and_what_all_cells_share_apart") {
  Task task;
  const VolumeGrid grid = plain_grid(80, 80);
  for (const auto& told : {std::pair{1.0, 0.0}, {2.0, 0.0}, {1.0, 0.01}, {2.0, 0.02}}) {
    const double scale = told.first, off_m = told.second;
    const GroundChange change = resting_cells(grid, scale, off_m);
    const std::vector<uint8_t> none(grid.cells(), 0);
    const GroundErrors found = ground_errors(grid, change, smoothed(grid, change, task), none);
    CAPTURE(scale);
    CAPTURE(off_m);
    CHECK(found.scale == doctest::Approx(scale).epsilon(0.1).scale(0));
    if (off_m == 0) CHECK(found.systematic_m < 0.0005);
    else
      CHECK(found.systematic_m ==
            doctest::Approx(1.48 * off_m).epsilon(0.1).scale(0));  // 1 / 0.6745
  }
}

TEST_CASE("ground_errors__of_a_slope_half_of_which_moved_are_those_of_the_other_half") {
  Task task;
  const VolumeGrid grid = plain_grid(80, 80);
  GroundChange change = resting_cells(grid, 1, 0);
  for (size_t cell = 0; cell < grid.cells() / 2; ++cell) change.difference[cell] -= 1;
  const GroundErrors found = ground_errors(grid, change, smoothed(grid, change, task), {});
  CHECK(found.scale < 1.6);
  CHECK(found.systematic_m < 0.002);
}
