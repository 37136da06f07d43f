// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/front/fronts.h"

#include <doctest/doctest.h>

#include "unit/segment/front/made_walls.h"

using namespace jalon;
using namespace jalon::test;

namespace {

/// Two houses across a street of 12 m, with panes and the ground between them; right: which way their fits look.
MadeWalls street_of(double right) {
  MadeWalls m;
  m.upright({right > 0 ? 0.0 : 10.0, 0, 0}, right, 10, 6, is_wall);
  m.upright({right > 0 ? 10.0 : 0.0, -12, 0}, -right, 10, 5.5, is_wall);
  m.upright({right > 0 ? 3.0 : 5.0, 0.2, 2}, right, 2, 2);
  m.upright({right > 0 ? 7.0 : 5.0, -12.2, 2}, -right, 2, 2);
  m.level({0, -12, 0}, 10, 12);
  return m;
}

}  // namespace

TEST_CASE(
    "wall_fronts__both_rows_of_a_street_look_into_it_whichever_way_their_planes_were_fitted") {
  for (const double right : {1.0, -1.0})
    for (const Vec3& shift : {Vec3{}, Vec3{652000, 6861000, 40}}) {
      CAPTURE(right);
      MadeWalls m = street_of(right);
      Task task;
      const CloudPtr cloud = cloud_of(m.points, shift);
      const std::vector<WallFront> fronts = wall_fronts(*cloud, shift, m.labels, m.segments, task);
      REQUIRE(fronts.size() == 2);
      for (const WallFront& front : fronts) {
        CHECK(front.is_before() == (right > 0));
        CHECK(front.confidence() > 0.99);
        CHECK(front.viewer.y < 0);
        CHECK(front.viewer.y > -12);
      }
    }
}

TEST_CASE("wall_fronts__a_bare_wall_is_even_odds") {
  MadeWalls m;
  m.upright({0, 0, 0}, 1, 8, 4);
  Task task;
  const std::vector<WallFront> fronts = wall_fronts(m.made(), {}, m.labels, m.segments, task);
  REQUIRE(fronts.size() == 1);
  CHECK(fronts[0].confidence() == 0.5);
  CHECK(wall_fronts(m.made(), {}, m.labels, {}, task).empty());
}

TEST_CASE("wall_fronts__the_same_bits_for_any_number_of_threads") {
  MadeWalls m = street_of(1);
  const auto with = [&](unsigned threads) {
    Task::Hooks hooks;
    hooks.threads = threads;
    Task task(hooks);
    return wall_fronts(m.made(), {}, m.labels, m.segments, task)[0].log_odds;
  };
  CHECK(with(1) == with(4));
}

TEST_CASE("wall_fronts__a_part_of_many_points_tells_the_same_sides") {
  constexpr size_t kMany = (1 << 20) + 1;  // more than are looked at
  MadeWalls m = street_of(-1);
  const size_t own = m.points.size();
  for (size_t i = 0; m.points.size() < kMany; ++i) {
    m.points.push_back(m.points[i % own]);
    m.labels.push_back(m.labels[i % own]);
  }
  Task task;
  const std::vector<WallFront> fronts = wall_fronts(m.made(), {}, m.labels, m.segments, task);
  REQUIRE(fronts.size() == 2);
  for (const WallFront& front : fronts) {
    CHECK(!front.is_before());
    CHECK(front.confidence() > 0.99);
  }
}
