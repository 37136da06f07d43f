// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Distances between contours, against those of forms that are known.
#include <doctest/doctest.h>

#include <cmath>

#include "modelling/evaluation/border_distances.h"
#include "unit/modelling/plane_rings.h"

using namespace rings;

namespace {

PolygonWithHoles box(double low, double high) {
  return {rectangle({low, low}, {high, high}).corners, {}};
}

}  // namespace

TEST_CASE("border_distances__of_a_contour_from_itself_are_nothing_holes_included") {
  PolygonWithHoles wall = box(0, 4);
  wall.holes.push_back(hole({1, 1}, {2, 2}).corners);
  const BorderComparison c = compare_borders({&wall, 1}, {&wall, 1}, 0.01, 0.01);
  CHECK(c.automatic.max_m < 1e-12);
  CHECK(c.automatic.within == doctest::Approx(1));
  CHECK(c.reference.within == doctest::Approx(1));
  CHECK(c.f1 == doctest::Approx(1));
  CHECK(c.hausdorff_m < 1e-12);
}

TEST_CASE("border_distances__of_concentric_squares_are_those_of_their_sides_and_corners") {
  const PolygonWithHoles inner = box(0, 4), outer = box(-0.1, 4.1);
  const BorderComparison c = compare_borders({&outer, 1}, {&inner, 1}, 0.1 + 1e-9, 0.001);
  CHECK(c.reference.max_m == doctest::Approx(0.1));  // inner corners are 0.1 from both sides
  CHECK(c.reference.mean_m == doctest::Approx(0.1));
  CHECK(c.reference.within == doctest::Approx(1));
  CHECK(c.automatic.max_m == doctest::Approx(0.1 * std::sqrt(2)));
  CHECK(c.hausdorff_m == c.automatic.max_m);
  // Of each side of 4.2 m 0.1 m at both ends is beyond the tolerance.
  CHECK(c.automatic.within == doctest::Approx(4.0 / 4.2).epsilon(0.002).scale(0));
  CHECK(c.f1 == doctest::Approx(2 * (4.0 / 4.2) / (1 + 4.0 / 4.2)).epsilon(0.002).scale(0));
  CHECK(c.hausdorff95_m >= 0.1);
  CHECK(c.hausdorff95_m < 0.101);
  const BorderComparison back = compare_borders({&inner, 1}, {&outer, 1}, 0.1 + 1e-9, 0.001);
  CHECK(back.automatic.mean_m == c.reference.mean_m);
  CHECK(back.hausdorff_m == c.hausdorff_m);
}

TEST_CASE("border_distances__go_by_the_share_of_the_length") {
  const PolygonWithHoles own[] = {box(0, 4), box(100, 101)};  // 4 m of 20 m are invented
  const BorderComparison c = compare_borders(own, {own, 1}, 0.01, 0.01);
  CHECK(c.automatic.within == doctest::Approx(0.8));
  CHECK(c.reference.within == doctest::Approx(1));
  CHECK(c.automatic.max_m == doctest::Approx(97 * std::sqrt(2)));
  CHECK(c.automatic.q95_m > 90);
}

TEST_CASE("border_distances__without_a_border_nothing_is_known") {
  const PolygonWithHoles square = box(0, 1);
  for (const BorderComparison& c : {compare_borders({}, {&square, 1}, 0.1, 0.01),
                                    compare_borders({&square, 1}, {}, 0.1, 0.01)}) {
    CHECK(std::isnan(c.hausdorff_m));
    CHECK(std::isnan(c.f1));
    CHECK(std::isnan(c.automatic.mean_m));
  }
}
