// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>

#include "modelling/evidence/wall_cells.h"

namespace jalon {

inline constexpr size_t kLookedAtCells = 20000;

/// f(place) of the measured cells of a plane, of as many as are looked at.
template <class F>
void for_measured(const WallCells& cells, F&& f) {
  const size_t step = std::max<size_t>(1, cells.states.size() / kLookedAtCells);
  for (size_t k = 0; k < cells.states.size(); k += step)
    if (cells.states[k] == WallState::kOn)
      f(cells.frame.lift(cells.origin +
                         Vec2{(static_cast<double>(k % cells.columns) + 0.5) * cells.cell_m,
                              (static_cast<double>(k / cells.columns) + 0.5) * cells.cell_m}));
}

/// A place straight before or behind a wall's plane.
struct Foot {
  Vec2 at;
  double depth_m = 0;  ///< behind the plane
  bool is_on_map = false;
  uint32_t column = 0, row = 0;

  Foot(const WallCells& wall, const Vec3& p)
      : at(wall.frame.project(p)),
        depth_m(wall.frame.height - dot(p - wall.frame.origin, wall.frame.normal)) {
    const double c = (at.u - wall.origin.u) / wall.cell_m, r = (at.v - wall.origin.v) / wall.cell_m;
    is_on_map = c >= 0 && r >= 0 && c < wall.columns && r < wall.rows;
    if (!is_on_map) return;
    column = static_cast<uint32_t>(c);
    row = static_cast<uint32_t>(r);
  }
};

}  // namespace jalon
