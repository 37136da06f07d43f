// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// A form laid onto the border points of a wall.
#include <doctest/doctest.h>

#include <cmath>

#include "base/random.h"
#include "geometry/polygon2.h"
#include "modelling/patterns/place.h"
#include "unit/modelling/plane_rings.h"

using namespace rings;

namespace {

const std::vector<Vec2> kForm{{0, 0}, {1, 0}, {1, 2}, {0, 2}};

/// Points round the form, this far outside it, moved.
std::vector<Vec2> border_of(const Motion2& motion, double set_back_m, double noise_m) {
  RandomStream random(2, 91);
  std::vector<Vec2> out;
  const auto add = [&](const Vec2& p) {
    out.push_back(motion.point(p + Vec2{noise_m * random.normal(), noise_m * random.normal()}));
  };
  for (double t = 0.02; t < 1; t += 0.04) add({t, -set_back_m}), add({t, 2 + set_back_m});
  for (double t = 0.02; t < 2; t += 0.04) add({-set_back_m, t}), add({1 + set_back_m, t});
  return out;
}

}  // namespace

TEST_CASE("place__a_motion_is_rigid_and_origin_of_undoes_it") {
  const Motion2 motion{{3, 1}, {0.5, -0.2}, 0.7};
  CHECK(norm(motion.point({3, 1}) - Vec2{3.5, 0.8}) < 1e-15);  // the pivot
  for (const Vec2& p : kForm) CHECK(norm(motion.origin_of(motion.point(p)) - p) < 1e-14);
  CHECK(norm(motion.point(kForm[0]) - motion.point(kForm[2])) == doctest::Approx(std::sqrt(5)));
  VectorRing ring = ring_of(kForm);
  ring.contour = kForm;
  const VectorRing out = moved(ring, motion);
  CHECK(signed_area(out) == doctest::Approx(2));
  CHECK(out.contour.empty());
}

TEST_CASE("place__finds_the_shift_and_turns_only_where_points_prove_it") {
  const Vec2 pivot{0.5, 1};
  for (const double turn : {0.0, 0.02}) {
    const Motion2 truth{pivot, {5.03, -1.98}, turn};
    const auto border = border_of(truth, 0.01, 0.002);
    const Placement p = place_on_border(kForm, 0.01, border, {5, -2}, 0.05, true);
    for (const Vec2& corner : kForm)
      CHECK(norm(p.motion.point(corner) - truth.point(corner)) < 0.003);
    if (turn == 0) CHECK(p.motion.turn_rad == 0);
    CHECK(p.support > border.size() * 9 / 10);
    CHECK(p.residual_m < 0.004);
    CHECK(place_on_border(kForm, 0.01, border, {5, -2}, 0.05, false).motion.turn_rad == 0);
  }
}

TEST_CASE("place__tells_the_sides_that_were_seen_and_what_lies_off") {
  std::vector<Vec2> border = border_of({}, 0.01, 0);
  std::erase_if(border, [](const Vec2& p) { return p.u > 0.5; });
  const size_t seen = border.size();
  border.push_back({0.5, 1});  // in the middle: of something else
  const Placement p = place_on_border(kForm, 0.01, border, {0, 0}, 0.05, false);
  CHECK(p.support == seen);
  CHECK(p.sides[0] > 40);
  CHECK(p.sides[1] == 0);
  CHECK(p.sides[2] == p.sides[3]);
  for (const double offset_m : p.offsets_m) CHECK(std::fabs(offset_m) < 1e-3);
  CHECK(p.cost_m2 ==
        doctest::Approx(0.05 * 0.05 / static_cast<double>(seen + 1)).epsilon(0.05).scale(0));
  CHECK(place_on_border(kForm, 0.01, {}, {0, 0}, 0.05, false).residual_m == 0.05);
}

TEST_CASE("place__distances_are_those_of_the_border_negative_inside") {
  const std::vector<Vec2> points{{-0.1, 1}, {0.5, 2.3}, {0.2, 1}, {1.3, 2.4}};
  CHECK(mean_distance(kForm, points) == doctest::Approx((0.1 + 0.3 - 0.2 + 0.5) / 4));
  CHECK(mean_distance(kForm, {}) == 0);
  CHECK(cost_in_place(kForm, {}, 0.1) == doctest::Approx(0.01));
  CHECK(cost_in_place(kForm, border_of({}, 0.03, 0), 0.1) < 1e-12);  // at any set-back
}

TEST_CASE("place__cells_count_whose_middle_lies_inside_by_the_margin") {
  WallMap map{{-1, -1}, 0.25, 16, 16, std::vector<WallCell>(256, WallCell::kSolid)};
  for (uint32_t r = 0; r < 16; ++r)
    for (uint32_t c = 0; c < 16; ++c)
      if (-1 + (c + 0.5) * 0.25 > 0.5) map.cells[r * 16 + c] = WallCell::kThrough;
  const CellCount all = count_cells(map, kForm, 0);
  CHECK(all.all() == 4 * 8);
  CHECK(all.share(WallCell::kSolid) == 0.5);
  CHECK(count_cells(map, kForm, 0.2).all() == 2 * 6);
  CHECK(count_cells({}, kForm, 0).all() == 0);
  CHECK(count_cells(map, {}, 0).share(WallCell::kSolid) == 0);
  // Beyond the map nothing is known.
  const std::vector<Vec2> beyond{{3.5, 0}, {4.5, 0}, {4.5, 1}, {3.5, 1}};
  CHECK(count_cells(map, beyond, 0).share(WallCell::kUnknown) == 1);
}
