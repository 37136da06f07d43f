// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "modelling/evidence/box_search.h"
#include "modelling/evidence/opening_shape.h"
#include "modelling/evidence/wall_cells.h"

// Rasters of a wall y = 0 that faces -y (u = x, v = z), painted by hand.
namespace painted {

using namespace jalon;

inline WallCells cells_of(uint32_t columns, uint32_t rows, WallState state = WallState::kOn,
                          double cell_m = 0.05) {
  WallCells out;
  out.frame = {{}, {1, 0, 0}, {0, 0, 1}, {0, -1, 0}, 0};
  out.spacing_m = cell_m / 2.2;
  out.on_m = 0.03;
  out.cell_m = cell_m;
  out.columns = columns;
  out.rows = rows;
  out.states.assign(size_t{columns} * rows, state);
  return out;
}

/// value over the columns [c0, c1) and rows [r0, r1) of a raster.
template <class T>
void paint(std::vector<T>& raster, uint32_t columns, const CellBox& box, T value) {
  for (uint32_t r = box.r0; r < box.r1; ++r)
    for (uint32_t c = box.c0; c < box.c1; ++c) raster[size_t{r} * columns + c] = value;
}
inline void paint(WallCells& cells, const CellBox& box, WallState state) {
  paint(cells.states, cells.columns, box, state);
}

inline OpeningShape rectangle(double left, double right, double foot, double head) {
  return {ShapeKind::kRectangle, {left, right, foot, head, 0, 0}};
}

}  // namespace painted
