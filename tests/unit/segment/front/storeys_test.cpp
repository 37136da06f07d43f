// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/front/storeys.h"

#include <doctest/doctest.h>

#include "unit/segment/front/made_walls.h"

using namespace jalon;
using namespace jalon::test;

namespace {

bool are_both(MadeWalls& m) {
  std::vector<WallSheet> sheets;
  std::vector<std::vector<Vec3>> probes(2);
  for (size_t s = 0; s < 2; ++s) {
    const WallSheet& sheet = sheets.emplace_back(m.sheet({s, {s}, {}}));
    for (size_t cell = 0; cell < sheet.cells(); cell += 7)
      if (sheet.is_solid(cell)) probes[s].push_back(sheet.point_of(sheet.middle_of(cell)));
  }
  const ProbedWall a{sheets[0], probes[0]}, b{sheets[1], probes[1]};
  CHECK(are_storeys(a, b) == are_storeys(b, a));
  return are_storeys(a, b);
}

}  // namespace

TEST_CASE("are_storeys__of_walls_over_one_another_that_stand_out_or_back_a_little") {
  for (const double out_m : {-0.6, 0.0, 0.35})
    for (const double right : {1.0, -1.0}) {
      MadeWalls m;
      m.upright({0, 0, 0}, 1, 10, 2.7);
      m.upright({right > 0 ? 0.0 : 10.0, -out_m, 2.75}, right, 10, 7);
      CHECK(are_both(m));
    }
}

TEST_CASE("are_storeys__also_where_panes_of_the_upper_one_lie_in_the_lower_ones_plane") {
  MadeWalls m;
  m.upright({0, 0, 0}, 1, 10, 5,
            [](double a, double b) { return b < 2.7 || (a > 3 && a < 3.3 && b > 3.5 && b < 4.5); });
  m.upright({0, -0.15, 2.7}, 1, 10, 7);
  CHECK(are_both(m));
}

TEST_CASE("are_storeys__not_of_walls_beside_each_other_or_one_before_the_other") {
  const Vec3 others[] = {{10, 0.1, 0}, {0, 0.4, 0}, {0, 1.5, 2.75}};
  for (const Vec3& corner : others) {
    MadeWalls m;
    m.upright({0, 0, 0}, 1, 10, 2.7);
    m.upright(corner, 1, 10, 2.7);
    CHECK(!are_both(m));
  }
}

TEST_CASE("are_storeys__not_of_walls_that_meet_at_a_corner") {
  MadeWalls m;
  m.upright({0, 0, 0}, 1, 0.8, 2.7);
  m.add({0, 0, 2.7}, {0, 1, 0}, {0, 0, 1}, 0.8, 2.7);
  CHECK(!are_both(m));
}
