// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/joint/strip_surfaces.h"

#include <doctest/doctest.h>

#include <algorithm>

using namespace jalon;

namespace {

// Beams from 8 m before the strip, 3 m above the ground, one every 0.1 m of height where they end.
struct Seen {
  std::vector<MetPoint> points;

  void surface(double before_m, double from_m, double to_m, bool is_accepted = true) {
    constexpr double kLaser_m = 3, kFrom_m = 8;
    for (double z = from_m; z < to_m; z += 0.1)
      points.push_back({static_cast<uint32_t>(points.size()), before_m, z,
                        (z - kLaser_m) / (kFrom_m - before_m), is_accepted});
  }
  // Share of the chosen points at this distance; -1: none is chosen.
  double share_at(double before_m) const {
    const std::vector<MetPoint> wall = points_of_wall(points);
    if (wall.empty()) return -1;
    const auto n = std::count_if(wall.begin(), wall.end(),
                                 [&](const MetPoint& p) { return p.distance_m == before_m; });
    return static_cast<double>(n) / static_cast<double>(wall.size());
  }
};

}  // namespace

TEST_CASE("points_of_wall__of_a_hoarding_with_most_points__are_those_of_the_wall_behind") {
  Seen seen;
  seen.surface(3, 0, 5);  // the beams that go over it meet the wall above 6.3 m
  seen.surface(0.2, 6.3, 10);
  CHECK(seen.share_at(0.2) == 1);
}

TEST_CASE("points_of_wall__of_a_hoarding_alone__are_none_where_beams_pass_over_it") {
  Seen seen;
  seen.surface(3, 0, 5);
  CHECK(seen.share_at(3) == 1);
  seen.surface(-6, 8, 11, false);
  CHECK(seen.share_at(3) == -1);
}

TEST_CASE("points_of_wall__beside_another_wall_behind__are_those_of_the_one_with_most") {
  Seen seen;
  seen.surface(0.3, 0, 9);
  seen.surface(-1.2, 0, 6);  // a neighbour that stands back, its beams below the eaves of this one
  CHECK(seen.share_at(0.3) == 1);
}

TEST_CASE("points_of_wall__with_joinery_set_back__are_one_surface") {
  Seen seen;
  seen.surface(0.1, 0, 9);
  seen.surface(0, 2, 4);
  CHECK(points_of_wall(seen.points).size() == seen.points.size());
  CHECK(points_of_wall({}).empty());
}
