// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "compare/comparison.h"

namespace jalon {

inline constexpr char kZoneColumn[] = "zone";

/// Is the comparison one of method "landslide"?
bool is_landslide(const Comparison& comparison);

/// The rows of a comparison of method "landslide" as cells of a grid. Throws kInvalidArgument where its columns or its
/// summary are not those of that method. The comparison outlives it.
class CellTable {
 public:
  static constexpr size_t kNone = SIZE_MAX;

  explicit CellTable(const Comparison& comparison);

  size_t size() const { return zone.size(); }
  /// Row of a cell; kNone: it is no part of the survey.
  size_t find(int64_t column, int64_t row) const;
  /// The row of the cell beside a row's, so many columns and rows away.
  size_t beside(size_t row, int columns, int rows) const {
    return find(int64_t{column[row]} + columns, int64_t{line[row]} + rows);
  }
  bool is_measured(size_t row) const { return status[row] == 0; }
  double cell_area_m2() const { return cell_m * cell_m; }
  /// Corner (column, row) of the grid, this far up from the plane of the first cell's centre.
  Vec3 corner(int64_t at_column, int64_t at_row, double height_m) const;

  std::span<const uint32_t> column, line, zone;  ///< line: of the grid
  std::span<const double> distance, sigma;
  std::span<const uint8_t> status, reference_status, compared_status;
  double cell_m = 1, systematic_m = 0;
  Vec3 first, up, u, v;

 private:
  std::vector<uint64_t> keys_;  ///< line, then column; ascending
};

}  // namespace jalon
