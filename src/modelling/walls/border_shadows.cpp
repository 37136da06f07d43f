// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/walls/border_shadows.h"

#include <algorithm>
#include <cmath>

#include "geometry/polygon2.h"
#include "modelling/evidence/cell_regions.h"
#include "modelling/evidence/cell_sums.h"
#include "modelling/evidence/contour_holes.h"

namespace jalon {

namespace {

constexpr double kBorderChord = 0.1;  // spacings
// A border that goes up and down from cell to cell is up to twice as long, and the place looks half as wide.
constexpr double kRagged = 0.5;

bool is_unmeasured(WallState state) {
  return state == WallState::kEmpty || state == WallState::kHidden || state == WallState::kProud;
}

/// One byte a cell: 1 for what belongs to the region.
struct CellMask {
  const WallCells& cells;
  std::vector<uint8_t> is_in;

  explicit CellMask(const WallCells& of) : cells(of), is_in(of.states.size(), 0) {}
  uint8_t& at(uint32_t c, uint32_t r) { return is_in[static_cast<size_t>(r) * cells.columns + c]; }
  uint8_t at(uint32_t c, uint32_t r) const {
    return is_in[static_cast<size_t>(r) * cells.columns + c];
  }
};

CellMask unmeasured_cells(const WallCells& cells) {
  CellMask out(cells);
  for (size_t k = 0; k < cells.states.size(); ++k) out.is_in[k] = is_unmeasured(cells.states[k]);
  return out;
}

// Some points between the leaves before a wall are no wall, and something seen past them is no opening: what is small
// is left out. Islands in a region would cut it into strips.
void fill_small_islands(CellMask& mask, double small_m2) {
  const WallCells& cells = mask.cells;
  std::vector<uint32_t> others;
  for (uint32_t k = 0; k < mask.is_in.size(); ++k)
    if (mask.is_in[k] == 0) others.push_back(k);
  for (const auto& island : CellRegions(cells.columns, cells.rows).of(others)) {
    const CellBox box = cell_box_of(island, cells.columns);
    if (static_cast<double>(island.size()) * cells.cell_m * cells.cell_m >= small_m2) continue;
    if (box.c0 == 0 || box.r0 == 0 || box.c1 == cells.columns || box.r1 == cells.rows) continue;
    if (std::any_of(island.begin(), island.end(),
                    [&](uint32_t k) { return cells.states[k] == WallState::kOutside; }))
      continue;
    for (const uint32_t k : island) mask.is_in[k] = 1;
  }
}

// Morphological opening with a square (Serra 1982): what is narrower than that goes, and joins no places.
void drop_strips(CellMask& mask, double least_width_m) {
  const uint32_t columns = mask.cells.columns, rows = mask.cells.rows;
  const auto edge = static_cast<uint32_t>(std::ceil(least_width_m / mask.cells.cell_m));
  if (edge < 2) return;
  const CellSums<uint32_t> in(columns, rows, [&](size_t k) { return uint32_t{mask.is_in[k]}; });
  std::vector<uint8_t> fits(mask.is_in.size(), 0);  // a square fits whose lower left cell it is
  for (uint32_t r = 0; r + edge <= rows; ++r)
    for (uint32_t c = 0; c + edge <= columns; ++c)
      fits[static_cast<size_t>(r) * columns + c] =
          in.of(c, r, c + edge, r + edge) == edge * edge ? 1 : 0;
  const CellSums<uint32_t> squares(columns, rows, [&](size_t k) { return uint32_t{fits[k]}; });
  for (uint32_t r = 0; r < rows; ++r)
    for (uint32_t c = 0; c < columns; ++c)
      mask.at(c, r) = squares.of(c + 1 > edge ? c + 1 - edge : 0, r + 1 > edge ? r + 1 - edge : 0,
                                 c + 1, r + 1) > 0;
}

// With the cells of the wall next to it: the wall's edge crosses these.
void grow(CellMask& mask) {
  const WallCells& cells = mask.cells;
  const CellMask before = mask;
  for (uint32_t r = 0; r < cells.rows; ++r)
    for (uint32_t c = 0; c < cells.columns; ++c) {
      if (before.at(c, r) == 0) continue;
      for (uint32_t y = r > 0 ? r - 1 : 0; y <= r + 1 && y < cells.rows; ++y)
        for (uint32_t x = c > 0 ? c - 1 : 0; x <= c + 1 && x < cells.columns; ++x)
          if (is_unmeasured(cells.at(x, y)) || is_wall(cells.at(x, y))) mask.at(x, y) = 1;
    }
}

// Cells that meet in a corner alone, one of each two taken out: rings touch themselves nowhere.
void part_at_corners(CellMask& mask) {
  for (bool is_changed = true; is_changed;) {
    is_changed = false;
    for (uint32_t r = 0; r + 1 < mask.cells.rows; ++r)
      for (uint32_t c = 0; c + 1 < mask.cells.columns; ++c) {
        uint8_t &a = mask.at(c, r), &b = mask.at(c + 1, r + 1), &d = mask.at(c + 1, r),
                &e = mask.at(c, r + 1);
        if (a != b || d != e || a == d) continue;
        (a != 0 ? b : e) = 0;
        is_changed = true;
      }
  }
}

// A box for each run of cells in a row.
std::vector<PolygonWithHoles> boxes_of(const CellMask& mask) {
  const WallCells& cells = mask.cells;
  std::vector<PolygonWithHoles> out;
  for (uint32_t r = 0; r < cells.rows; ++r)
    for (uint32_t c = 0; c < cells.columns; ++c) {
      if (mask.at(c, r) == 0) continue;
      const uint32_t first = c;
      while (c < cells.columns && mask.at(c, r) != 0) ++c;
      const Vec2 low = cells.origin + Vec2{double(first), double(r)} * cells.cell_m,
                 high = cells.origin + Vec2{double(c), double(r + 1)} * cells.cell_m;
      out.push_back(box_polygon(low.u, low.v, high.u, high.v));
    }
  return out;
}

// The face whose border comes nearest.
uint32_t nearest_face(const std::vector<PolygonWithHoles>& faces, const std::vector<Vec2>& place) {
  uint32_t nearest = 0;
  double least = INFINITY;
  for (size_t f = 0; f < faces.size(); ++f)
    for (const Vec2& p : place)
      if (const double d = border_distance(faces[f].outline, p); d < least) {
        least = d;
        nearest = static_cast<uint32_t>(f);
      }
  return nearest;
}

}  // namespace

std::vector<FacadeShadow> border_shadows(const VectorPlane& plane, const FacadeWall& wall,
                                         const WallCells& cells, const ContourSetting& setting,
                                         Task& task) {
  std::vector<FacadeShadow> out;
  if (plane.faces.empty() || cells.empty()) return out;
  // 1. Where nobody measured.
  CellMask mask = unmeasured_cells(cells);
  fill_small_islands(mask, setting.min_opening_area_m2);
  drop_strips(mask, setting.min_opening_width_m);
  grow(mask);
  part_at_corners(mask);
  task.checkpoint(0);
  // 2. What is drawn already.
  const double chord_m = kBorderChord * plane.spacing_m;
  std::vector<PolygonWithHoles> faces;
  for (const VectorFace& face : plane.faces)
    faces.push_back({flattened(face.outline, chord_m), {}});
  std::vector<PolygonWithHoles> taken = faces;
  for (const FacadeOpening& opening : wall.openings)
    taken.push_back({flattened(opening.outline, chord_m), {}});
  for (const FacadeShadow& shadow : wall.shadows)
    if (shadow.is_notch) taken.push_back({flattened(shadow.outline, chord_m), {}});
  // 3. What that leaves.
  for (PolygonWithHoles& left : without(boxes_of(mask), std::move(taken), plane.spacing_m)) {
    const double area_m2 = signed_area(left.outline);
    if (area_m2 < setting.min_opening_area_m2 ||
        equivalent_width(area_m2, perimeter(left.outline)) < kRagged * setting.min_opening_width_m)
      continue;
    FacadeShadow& shadow = out.emplace_back();
    shadow.piece = nearest_face(faces, left.outline);
    shadow.outline.edges.resize(left.outline.size());
    shadow.outline.corners = std::move(left.outline);
    shadow.is_notch = true;
  }
  return out;
}

}  // namespace jalon
