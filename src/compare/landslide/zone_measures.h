// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "compare/landslide/cell_table.h"

namespace jalon {

/// What a zone that moved measures; lengths and areas across the direction.
struct ZoneMeasure {
  uint32_t zone = 0;
  std::vector<uint32_t> rows;  ///< its cells
  double area_m2 = 0;
  double volume_m3 = 0;        ///< with the cells that its boundary runs through; negative: gone
  double volume_sigma_m3 = 0;  ///< of the cells and of what they share
  double boundary_m = 0;       ///< of its outline
  double open_boundary_m = 0;  ///< of that, along ground that was not measured: it may go on there
};

/// Of every zone, 1, 2 ... The measured cells about a zone that are of none are its own as far as volume goes, those of
/// two zones the lower one's: where it runs out its movement is below the level of detection.
std::vector<ZoneMeasure> zone_measures(const CellTable& cells);

/// Adds to the summary what all zones and all cells without a measurement come to.
void add_totals(Comparison& comparison);

}  // namespace jalon
