// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "modelling/patterns/types.h"

namespace jalon {

/// A row or a column of openings: the mean of their centres along one axis.
struct GridLine {
  double at = 0;
  std::vector<size_t> openings;
};

/// Rows (one height) and columns of a wall's openings as far as they make a regular grid; without lines where they do
/// not.
struct OpeningGrid {
  std::vector<GridLine> rows, columns;
  double sigma_m = 0;  ///< standard deviation of its openings' middles about their lines

  /// Variance of where an opening of that line has its middle.
  double variance_m2(const GridLine& line) const {
    return sigma_m * sigma_m *
           (1 + 1 / static_cast<double>(std::max<size_t>(1, line.openings.size())));
  }

  /// The line within reach, or null.
  const GridLine* row_near(double v, double reach_m) const { return near(rows, v, reach_m); }
  const GridLine* column_near(double u, double reach_m) const { return near(columns, u, reach_m); }

 private:
  static const GridLine* near(const std::vector<GridLine>& lines, double at, double reach_m);
};

/// Farthest that an opening of a row lies from its line.
double grid_reach_m(const FacadeWall& wall, const PatternSetting& setting);

/// The grid of the openings told, with their boxes (one an opening of the wall). Lines whose crossings are mostly bare
/// wall are left out. What remains is a grid when it has two rows and two columns or four openings at equal distances,
/// and when enough of its crossings are taken, of those where a wall or an opening can be seen.
OpeningGrid find_grid(const FacadeWall& wall, std::span<const size_t> openings,
                      std::span<const RingBox> boxes, const PatternSetting& setting);

/// The pattern that most of the row and the column show; it must be in the row, or in the column of a single one. Their
/// number when there is none.
size_t pattern_at(std::span<const Pattern> patterns, const GridLine& row, const GridLine& column);

}  // namespace jalon
