// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/patterns/site.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "geometry/polygon2.h"
#include "modelling/patterns/place.h"
#include "modelling/patterns/types.h"

namespace jalon {

namespace {

constexpr double kSolidInside =
    0.05;  // share of a form's cells where points of the wall may lie: strays
constexpr double kThroughBeside = 0.10;  // of its cells, seen through beside it
constexpr double kAround_cells = 8;      // beside an opening, where its local spacing shows
constexpr double kSolidWhereLit =
    0.75;  // share of the wall's cells, one spacing wide, that have a point: 0.6-0.95
constexpr double kLeastLit = 0.1;  // of it; a copy from fewer points is a guess

constexpr auto kSiteSolid = static_cast<size_t>(WallCell::kSolid),
               kThrough = static_cast<size_t>(WallCell::kThrough);

CellCount cells_in(const WallMap& map, const RingBox& b) {
  return count_cells(
      map, std::array{b.low, Vec2{b.high.u, b.low.v}, b.high, Vec2{b.low.u, b.high.v}}, 0);
}

}  // namespace

uint32_t piece_around(const FacadeWall& wall, std::span<const Vec2> form) {
  size_t k = 0;
  for (; k < wall.outlines.size(); ++k) {
    const std::vector<Vec2> face = outline_points(wall.outlines[k]);
    if (std::all_of(form.begin(), form.end(), [&](const Vec2& p) { return contains(face, p); }))
      break;
  }
  return static_cast<uint32_t>(k);
}

double spacing_beside(const FacadeWall& wall, const RingBox& box) {
  const double cell_m = wall.map.cell_m;
  const CellCount all = cells_in(wall.map, box.grown(kAround_cells * cell_m));
  const CellCount inner = cells_in(wall.map, box.grown(cell_m));
  const auto solid = static_cast<double>(all.of[kSiteSolid] - inner.of[kSiteSolid]);
  const auto cells = static_cast<double>(all.all() - inner.all());
  const double lit = cells > 0 ? solid / cells / kSolidWhereLit : 1;
  return wall.spacing_m / std::sqrt(std::clamp(lit, kLeastLit, 1.0));
}

bool shows_wall(const FacadeWall& wall, std::span<const Vec2> form) {
  const CellCount cells = count_cells(wall.map, form, wall.map.cell_m);
  return cells.all() == 0 || cells.share(WallCell::kSolid) > kSolidInside;
}

bool shows_more(const FacadeWall& wall, const VectorRing& hole, std::span<const Vec2> form) {
  const size_t in_hole = count_cells(wall.map, outline_points(hole), wall.map.cell_m).of[kThrough];
  const CellCount in_form = count_cells(wall.map, form, 0);
  const size_t beside = in_hole - std::min(in_hole, in_form.of[kThrough]);
  return static_cast<double>(beside) > kThroughBeside * static_cast<double>(in_form.all());
}

}  // namespace jalon
