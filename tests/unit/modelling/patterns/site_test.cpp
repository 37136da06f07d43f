// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// What the wall says about a place for a copy.
#include <doctest/doctest.h>

#include <cmath>

#include "modelling/patterns/site.h"
#include "unit/modelling/plane_rings.h"

using namespace rings;

namespace {

constexpr double kCell = 0.05;

/// A wall of 8 x 4 m whose cells are as cell(middle) says.
template <class F>
FacadeWall wall_of_cells(F&& cell) {
  FacadeWall out;
  out.spacing_m = 0.03;
  out.outlines = {rectangle({0, 0}, {4, 4}), rectangle({4, 0}, {8, 4})};
  out.map = {{0, 0}, kCell, 160, 80, {}};
  for (uint32_t r = 0; r < 80; ++r)
    for (uint32_t c = 0; c < 160; ++c)
      out.map.cells.push_back(cell(Vec2{(c + 0.5) * kCell, (r + 0.5) * kCell}));
  return out;
}

const std::vector<Vec2> kSiteForm = rectangle({1, 1}, {2, 3}).corners;
bool in_form(const Vec2& p) { return p.u > 1 && p.u < 2 && p.v > 1 && p.v < 3; }

}  // namespace

TEST_CASE("site__a_form_lies_in_the_face_that_holds_all_of_it") {
  const FacadeWall wall = wall_of_cells([](const Vec2&) { return WallCell::kSolid; });
  CHECK(piece_around(wall, kSiteForm) == 0);
  CHECK(piece_around(wall, rectangle({5, 1}, {6, 3}).corners) == 1);
  CHECK(piece_around(wall, rectangle({3.5, 1}, {4.5, 3}).corners) == 2);  // across both
  CHECK(piece_around(wall, rectangle({7, 1}, {9, 3}).corners) == 2);
}

TEST_CASE("site__points_of_the_wall_in_it_speak_against_a_copy_and_a_few_strays_do_not") {
  const auto with = [](double solid_to_v) {
    return wall_of_cells([=](const Vec2& p) {
      return !in_form(p) || p.v < solid_to_v ? WallCell::kSolid : WallCell::kHidden;
    });
  };
  CHECK(!shows_wall(with(0), kSiteForm));
  CHECK(!shows_wall(with(1.1), kSiteForm));
  CHECK(shows_wall(with(1.3), kSiteForm));
  CHECK(shows_wall(with(0), rectangle({1, 1}, {1.04, 1.04}).corners));  // too small to say
  CHECK(shows_wall(with(0), rectangle({5, 1}, {6, 3}).corners));
}

TEST_CASE("site__a_hole_that_shows_more_than_the_form_has_another_form") {
  const FacadeWall wall = wall_of_cells([](const Vec2& p) {
    return p.u > 1 && p.u < 3 && p.v > 1 && p.v < 3 ? WallCell::kThrough : WallCell::kSolid;
  });
  CHECK(shows_more(wall, rectangle({1, 1}, {3, 3}), kSiteForm));
  CHECK(!shows_more(wall, rectangle({1, 1}, {2, 3}), kSiteForm));
  CHECK(!shows_more(wall, rectangle({1, 1}, {2.1, 3}), kSiteForm));
}

TEST_CASE("site__the_spacing_beside_a_box_grows_where_only_some_cells_have_points") {
  RingBox box;
  box.add(std::span<const Vec2>(kSiteForm));
  const auto spacing = [&](int one_of) {
    int k = 0;
    return spacing_beside(wall_of_cells([&](const Vec2&) {
                            return k++ % one_of == 0 ? WallCell::kSolid : WallCell::kHidden;
                          }),
                          box);
  };
  CHECK(spacing(1) == doctest::Approx(0.03));
  CHECK(spacing(4) == doctest::Approx(2 * spacing(1) * std::sqrt(0.75)).epsilon(0.05).scale(0));
  CHECK(spacing(1000) == doctest::Approx(0.03 / std::sqrt(0.1)));  // and no further
  FacadeWall none;
  none.spacing_m = 0.03;
  CHECK(spacing_beside(none, box) == 0.03);  // without a map: that of the wall
}
