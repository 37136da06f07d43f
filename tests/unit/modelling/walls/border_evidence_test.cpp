// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// How much of an opening's outline was seen.
#include <doctest/doctest.h>

#include <cmath>

#include "modelling/plane/ring_tools.h"
#include "modelling/walls/border_evidence.h"
#include "unit/modelling/plane_rings.h"

using namespace rings;

namespace {

constexpr double kCell = 0.05;
constexpr Vec2 kLow{1, 1}, kHigh{2, 3};

FacadeWall plain_wall() {
  FacadeWall wall;
  wall.label = 1;
  wall.spacing_m = kCell;
  wall.map = {{0, 0}, kCell, 80, 80, std::vector<WallCell>(6400, WallCell::kThrough)};
  return wall;
}

/// A point of the wall every half cell round the opening, this far outside.
HoleSurvey points_round(double off_m) {
  HoleSurvey out;
  const auto add = [&](double u, double v) {
    out.points.push_back({0, 1, static_cast<float>(u), static_cast<float>(v), 0});
  };
  for (double u = kLow.u; u <= kHigh.u; u += kCell / 2) {
    add(u, kLow.v - off_m);
    add(u, kHigh.v + off_m);
  }
  for (double v = kLow.v; v <= kHigh.v; v += kCell / 2) {
    add(kLow.u - off_m, v);
    add(kHigh.u + off_m, v);
  }
  return out;
}

FacadeOpening measured(const FacadeWall& wall, const HoleSurvey& survey, bool at_sill = false) {
  FacadeOpening out;
  out.outline = rectangle(kLow, kHigh);
  out.ends_at_sill = at_sill;
  measure_border(wall, survey, out);
  return out;
}

}  // namespace

TEST_CASE("border_evidence__an_opening_seen_all_round_is_covered_by_points_outside_it") {
  const FacadeOpening opening = measured(plain_wall(), points_round(0.02));
  CHECK(opening.coverage == doctest::Approx(1));
  CHECK(opening.residual_m < 1e-6);  // all at one distance: the set-back
  CHECK(opening.border_points.size() == 120);
  RingBox box;
  box.add(std::span<const Vec2>(opening.outline.corners));
  for (const Vec2& p : opening.border_points) CHECK(!box.grown(0.019).holds(p));
}

TEST_CASE("border_evidence__counts_no_points_of_others_far_ones_or_none") {
  HoleSurvey others = points_round(0.02);
  for (HolePoint& p : others.points)
    if (p.v > 2) p.label = 7;
  const FacadeOpening half = measured(plain_wall(), others);
  CHECK(half.coverage == doctest::Approx(0.5).epsilon(0.05).scale(0));
  CHECK(measured(plain_wall(), points_round(0.12)).coverage == 0);  // above two cells
  const FacadeOpening none = measured(plain_wall(), {});
  CHECK(none.coverage == 0);
  CHECK(std::isnan(none.residual_m));
  CHECK(none.border_points.empty());
}

TEST_CASE("border_evidence__what_something_in_front_hides_is_not_seen") {
  FacadeWall wall = plain_wall();
  for (uint32_t r = 0; r < wall.map.rows; ++r)
    for (uint32_t c = 0; c < wall.map.columns; ++c)
      if ((r + 0.5) * kCell > 2) wall.map.cells[r * wall.map.columns + c] = WallCell::kHidden;
  const FacadeOpening opening = measured(wall, points_round(0.02));
  CHECK(opening.coverage == doctest::Approx(0.5).epsilon(0.05).scale(0));
  for (const Vec2& p : opening.border_points) CHECK(p.v < 2.1);
}

TEST_CASE("border_evidence__the_upper_edge_of_a_sill_does_not_count") {
  HoleSurvey above = points_round(0.02);
  std::erase_if(above.points, [](const HolePoint& p) { return p.v < kLow.v; });
  CHECK(measured(plain_wall(), above).coverage < 0.9);
  CHECK(measured(plain_wall(), above, true).coverage == doctest::Approx(1));
}
