// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Cells over a wall and the holes they belong to.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "geometry/polygon2.h"
#include "modelling/walls/raster.h"
#include "unit/modelling/plane_rings.h"

using namespace rings;

namespace {

WallHole hole_of(VectorRing outline, bool is_notch = false) {
  WallHole out;
  out.outline = std::move(outline);
  out.is_notch = is_notch;
  return out;
}

}  // namespace

TEST_CASE("wall_raster__cells_are_of_the_hole_that_holds_their_middle_the_later_one_first") {
  const VectorPlane wall = wall_of({{rectangle({0.5, 0.25}, {6, 4}), {}}}, 0.1);
  VectorRing arch = rectangle({3, 1}, {5, 2});
  arch.edges[2].sagitta_m = 1;
  const std::vector<WallHole> holes{hole_of(rectangle({1, 1}, {2.03, 2.57})), hole_of(arch),
                                    hole_of(rectangle({1.5, 2}, {2.5, 3}))};
  const WallRaster raster = rasterise_wall(wall, holes);
  CHECK(raster.cell_m == 0.1);
  std::vector<std::vector<Vec2>> polygons;
  for (const WallHole& h : holes) polygons.push_back(flattened(h.outline, 1e-4));
  for (uint32_t r = 0; r < raster.rows; ++r)
    for (uint32_t c = 0; c < raster.columns; ++c) {
      const Vec2 p = raster.centre(c, r);
      uint32_t expected = kNoHole;
      bool is_clear = true;  // of arcs drawn with coarser chords
      for (uint32_t h = 0; h < 3; ++h) {
        if (contains(polygons[h], p)) expected = h;
        is_clear = is_clear && border_distance(polygons[h], p) > 0.011;
      }
      CHECK(raster.cell_of(p) == r * raster.columns + c);
      if (is_clear) CHECK(raster.hole[r * raster.columns + c] == expected);
    }
}

TEST_CASE("wall_raster__has_two_cells_about_the_wall_and_nothing_beyond") {
  const VectorPlane wall =
      wall_of({{rectangle({0, 0}, {3, 2}), {}}, {rectangle({5, 1}, {6, 4}), {}}}, 0.05);
  const WallRaster raster = rasterise_wall(wall, {});
  for (const Vec2& p : {Vec2{0, 0}, Vec2{6, 4}, Vec2{-0.099, -0.099}, Vec2{6.099, 4.099}})
    CHECK(raster.cell_of(p) != kNoCell);
  for (const Vec2& p : {Vec2{-1, 1}, Vec2{1, -1}, Vec2{7, 1}, Vec2{1, 5}})
    CHECK(raster.cell_of(p) == kNoCell);
  CHECK(raster.hole.size() == size_t{raster.columns} * raster.rows);
  CHECK(
      std::all_of(raster.hole.begin(), raster.hole.end(), [](uint32_t h) { return h == kNoHole; }));
  CHECK(rasterise_wall(wall_of({}, 0.05), {}).hole.empty());
  // A kilometre in cells of a millimetre would be too many.
  const WallRaster wide = rasterise_wall(wall_of({{rectangle({0, 0}, {1000, 100}), {}}}, 1e-3), {});
  CHECK(wide.cell_m > 0.1);
}

TEST_CASE("wall_raster__near_a_hole_are_two_cells_more_and_what_lies_below_a_notch") {
  const VectorPlane wall = wall_of({{rectangle({0, 0}, {6, 4}), {}}}, 0.1);
  const std::vector<WallHole> holes{hole_of(rectangle({1, 2}, {2, 3})),
                                    hole_of(rectangle({4, 0}, {5, 2}), true)};
  const WallRaster raster = rasterise_wall(wall, holes);
  const auto near = [&](double u, double v) { return raster.near_hole[raster.cell_of({u, v})]; };
  const auto in = [&](double u, double v) { return raster.hole[raster.cell_of({u, v})]; };
  CHECK(in(0.85, 2.5) == kNoHole);
  CHECK(near(0.85, 2.5) == 0);
  CHECK(near(0.75, 2.5) == kNoHole);
  CHECK(near(1.5, 3.15) == 0);
  CHECK(in(4.5, -0.5) == kNoHole);
  CHECK(near(4.5, -0.5) == 1);
  CHECK(near(4.5, -1.4) == 1);
  CHECK(near(1.5, -0.15) == kNoHole);
}
