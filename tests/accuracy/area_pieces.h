// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Where an area lies that a table sums up: its connected pieces, for those who look for causes.
#pragma once

#include <iomanip>
#include <sstream>
#include <string>

#include "geometry/vec.h"
#include "modelling/evidence/cell_regions.h"

namespace jalon::test {

constexpr double kNotedPiece_m2 = 0.1;  ///< smaller ones are borders

/// A line a piece of these cells of a map.
inline std::string text_of_pieces(const std::string& what, std::span<const uint32_t> cells,
                                  uint32_t columns, uint32_t rows, const Vec2& low, double cell_m) {
  std::ostringstream out;
  out << std::fixed << std::setprecision(2);
  CellRegions regions(columns, rows);
  for (const std::vector<uint32_t>& piece : regions.of(cells)) {
    const double area_m2 = static_cast<double>(piece.size()) * cell_m * cell_m;
    if (area_m2 < kNotedPiece_m2) continue;
    const CellBox box = cell_box_of(piece, columns);
    out << "\n    " << what << " " << area_m2 << " m2, u " << low.u + box.c0 * cell_m << ".."
        << low.u + box.c1 * cell_m << ", v " << low.v + box.r0 * cell_m << ".."
        << low.v + box.r1 * cell_m;
  }
  return out.str();
}

}  // namespace jalon::test
