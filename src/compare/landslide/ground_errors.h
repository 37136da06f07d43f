// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "compare/volumes/volume_grid.h"

namespace jalon {

/// How a slope's cells differ between two epochs: compared above reference along the direction.
struct GroundChange {
  std::vector<double> difference;  ///< NaN unless both are measured
  std::vector<double> sigma;       ///< of that, by both epochs' points

  bool is_measured(size_t cell) const { return difference[cell] == difference[cell]; }
};

/// What ground at rest shows of errors beyond the points' scatter (after Hugonnet et al. 2022: an error of each cell,
/// scaled so that it holds on stable ground, and one that cells share).
struct GroundErrors {
  double scale = 1;           ///< of the cells' sigma; 1 at least
  double smoothed_scale = 1;  ///< the same of means over nine cells
  double systematic_m = 0;    ///< standard deviation of what whole blocks of cells are off
};

/// The mean over a cell and the measured ones of the eight around it, weighted by their variances, and its sigma; NaN
/// where it is not measured.
struct SmoothedChange {
  std::vector<double> mean_m, sigma_m;
};
SmoothedChange smoothed(const VolumeGrid& grid, const GroundChange& change, Task& task);

/// From the measured cells that have not moved. moved: not 0 where it has, or may have; empty: not known yet, the
/// scales are then those of the calmest quarter of the cells.
GroundErrors ground_errors(const VolumeGrid& grid, const GroundChange& change,
                           const SmoothedChange& smooth, std::span<const uint8_t> moved);

}  // namespace jalon
