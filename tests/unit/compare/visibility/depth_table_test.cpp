// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// The table of a depth map against the points that it was made from.
#include "compare/visibility/depth_table.h"

#include <doctest/doctest.h>

#include <cmath>

#include "unit/cloud/clouds.h"
#include "unit/compare/lattice.h"

using namespace jalon;
using namespace jalon::test;

namespace {

/// A wall of which one pulse in four is lost, and no sky above.
Cloud thin_wall() {
  RandomStream random(81, 0);
  return lattice({}, {}, [&](const Vec3& d) {
    if (d.z > 0.2) return d.x > 0.4 ? 10 / d.y : 0.0;
    return random.uniform() < 0.25 ? 0.0 : 10 / d.y;
  });
}

}  // namespace

TEST_CASE("depth_table__rows_are_the_cells_and_lead_back_to_the_points") {
  Task task;
  const Cloud cloud = thin_wall();
  DepthSettings settings;
  settings.cell_factor = 1;
  const FieldTable t = depth_table(station_depth_map(cloud, 0, settings, task), task);
  const auto of = [&](const char* name, size_t row) { return t.require(name).number(row); };
  const size_t cells = t.require("range").count();
  REQUIRE(cells > 7000);
  double points = 0;
  size_t empty = 0, filled = 0;
  for (size_t c = 0; c < cells; ++c) {
    points += of("points", c);
    empty += of("fill", c) == 0;
    filled += of("fill", c) == 2;
    REQUIRE(std::isnan(of("range", c)) == (of("fill", c) == 0));
    REQUIRE((of("points", c) > 0) == (of("fill", c) == 1));
    if (of("fill", c) != 1) {
      REQUIRE(of("nearest", c) == 4294967295.0);
      continue;
    }
    // The point lies in the cell of a hundredth, so within half of it from the centre either way, at its range.
    const Vec3 p = cloud.point(static_cast<size_t>(of("nearest", c)));
    REQUIRE(std::fabs(std::atan2(p.x, p.y) - of("horizontal", c)) < 0.00505);
    REQUIRE(std::fabs(std::asin(p.z / norm(p)) - of("vertical", c)) < 0.00505);
    REQUIRE(of("range", c) >= norm(p) * (1 - 1e-6));
  }
  CHECK(points == static_cast<double>(cloud.size()));
  CHECK(empty > 1000);   // the sky
  CHECK(filled > 1000);  // lost pulses
}

TEST_CASE("depth_table__needs_a_station_with_a_pose_and_says_which") {
  Task task;
  Cloud cloud = thin_wall();
  cloud.stations[0].name = "roof";
  const auto made = [&](uint64_t station, const DepthSettings& settings = {}) {
    return station_depth_map(cloud, station, settings, task);
  };
  CHECK(made(0).grid().size() > 0);
  CHECK(status_of([&] { made(1); }) == Status::kInvalidArgument);
  CHECK_THROWS_WITH_AS(made(1), doctest::Contains("station 1 "), Error);
  DepthSettings settings;
  settings.second_centre_m = {1, 2};
  CHECK_THROWS_WITH_AS(made(0, settings), doctest::Contains("second_centre_m"), Error);
  cloud.stations[0].has_pose = false;
  CHECK(status_of([&] { made(0); }) == Status::kInvalidArgument);
  CHECK_THROWS_WITH_AS(made(0), doctest::Contains("\"roof\""), Error);
}
