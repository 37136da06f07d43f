// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/front/shared_viewers.h"

#include <doctest/doctest.h>

#include <cmath>

#include "unit/segment/front/made_walls.h"

using namespace jalon;
using namespace jalon::test;

namespace {

// Log odds of the first wall 6, of all others 0; each segment is a wall.
std::vector<double> shared(MadeWalls& m) {
  std::vector<WallSheet> sheets;
  for (size_t s = 0; s < m.segments.size(); ++s) sheets.push_back(m.sheet({s, {s}, {}}));
  std::vector<double> odds(sheets.size(), 0);
  odds[0] = 6;
  share_viewers(sheets, odds);
  return odds;
}

}  // namespace

TEST_CASE("share_viewers__walls_in_view_of_a_sure_ones_viewer_were_seen_from_there") {
  MadeWalls m;
  m.upright({0, 0, 0}, 1, 10, 6);      // looks along -Y
  m.upright({10, -12, 0}, -1, 10, 6);  // across the street, looks along +Y
  m.upright({10, 1.5, 0}, 1, 8, 6);    // set back beside it
  m.upright({28, 1.4, 0}, -1, 8, 6);   // and one that is fitted the other way round
  const std::vector<double> odds = shared(m);
  CHECK(odds[0] == 6);
  CHECK(odds[1] > 2);
  CHECK(odds[2] > 2);
  CHECK(odds[3] < -2);
}

TEST_CASE("share_viewers__says_nothing_of_a_wall_that_is_hidden_from_the_viewer") {
  MadeWalls m;
  m.upright({0, 0, 0}, 1, 10, 6);
  m.upright({0, 8, 0}, 1, 10, 5);  // the back of the house
  const std::vector<double> odds = shared(m);
  CHECK(odds[1] == 0);
}

TEST_CASE("share_viewers__a_sure_storey_tells_the_larger_one_that_stands_out_over_it") {
  for (const double right : {1.0, -1.0}) {
    MadeWalls m;
    m.upright({0, 0, 0}, 1, 10, 2.5);
    m.upright({right > 0 ? 0.0 : 10.0, -0.3, 2.5}, right, 10, 9);
    CHECK(right * shared(m)[1] > 5);
  }
}

TEST_CASE("share_viewers__the_back_wall_of_an_arcade_was_seen_through_its_arches") {
  MadeWalls m;
  m.upright({0, 3.8, 0}, 1, 12, 3.5);
  // Four arches and three storeys of wall over them.
  m.upright({0, 0, 0}, 1, 12, 12,
            [](double a, double b) { return b > 3.5 || std::fmod(a, 3) < 0.5; });
  CHECK(shared(m)[1] > 0.5);
}

TEST_CASE("share_viewers__a_small_wall_in_a_room_says_little_of_the_facade_before_it") {
  MadeWalls m;
  m.upright({4, 4, 1}, 1, 2, 2);
  m.upright({0, 0, 0}, 1, 10, 10, is_wall);
  CHECK(std::fabs(shared(m)[1]) < 0.7);
}
