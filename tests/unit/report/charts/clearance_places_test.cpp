// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "report/charts/clearance_places.h"

#include <doctest/doctest.h>

#include <cmath>

#include "unit/report/charts/swept_gauge.h"

using namespace jalon;

TEST_CASE("clearance_places__one_for_obstacles_beside_each_other_and_the_tightest_first") {
  const GaugePath path(swept::way());
  const auto tight = tight_places(swept::tables().places, path, 1, 40);
  REQUIRE(tight.size() == 2);
  CHECK(tight[0].clearance_m == doctest::Approx(-0.1));
  CHECK(tight[0].obstacle.x == 15);
  CHECK(tight[1].clearance_m == doctest::Approx(0.05));
  CHECK(tight[1].obstacle.x == 5);
  CHECK(tight_places(swept::tables().places, path, 0.1, 40).size() == 3);
  CHECK(tight_places(swept::tables().places, path, 0.1, 1).size() == 1);
}

TEST_CASE("clearance_places__right_and_above_are_seen_along_the_travel") {
  const auto tight = tight_places(swept::tables().places, GaugePath(swept::way()), 1, 40);
  REQUIRE(tight.size() == 2);
  CHECK(tight[1].in_section.x ==
        doctest::Approx(-1.05));  // y to the north is left of a way to the east
  CHECK(tight[1].in_section.y == doctest::Approx(1));
  CHECK(tight[1].gauge_in_section.x == doctest::Approx(-1));
  CHECK(tight[0].in_section.x == doctest::Approx(0.9));
}

TEST_CASE("clearance_places__chainage_runs_from_end_to_end_and_not_beyond") {
  const GaugePath path(swept::way());
  CHECK(path.length_m() == 20);
  CHECK(path.chainage_m(2.5) == doctest::Approx(5));
  CHECK(path.chainage_m(10) == 20);
  CHECK(path.chainage_m(99) == 20);
  CHECK(path.chainage_m(std::nan("")) == 0);
  const GaugePath standing({Transform{}});
  CHECK(standing.chainage_m(0.5) == 0);
  CHECK(standing.section(0).point({0, 1, 2}).x == doctest::Approx(-1));
}
