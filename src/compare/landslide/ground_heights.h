// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "base/buffer.h"
#include "cloud/cloud.h"
#include "compare/volumes/volume_grid.h"

namespace jalon {

/// The ground of one epoch, one value a cell.
struct GroundHeights {
  Buffer<double> height;     ///< mean over the cell, along the grid's direction; NaN: not measured
  Buffer<double> variance;   ///< of that, by the scatter of the points and the gaps between them
  Buffer<double> gap_sigma;  ///< of it, if what has no points lies to one side, as in a shadow
  Buffer<uint32_t> points;
  explicit GroundHeights(size_t cells)
      : height(cells), variance(cells), gap_sigma(cells), points(cells) {}
};

/// Each cell by nine parts of it, so that points lying close together, as along the lines of a scan, count as one
/// place: 1. the mean of each part with points; 2. the slope, by the parts of the cell and of the eight around it; 3.
/// the mean of the parts, brought to the cell's middle by that slope. Its variance is that of a sample of nine parts
/// without replacement (Cochran 1977, 2.5: roughness where parts are empty), of the scatter within the parts, of the
/// roughness where the points of a part lie aside, and of the slope. The sigma of a gap takes all parts without points
/// for one place as far off the plane as parts are. Not measured: fewer than min_points points, or fewer than four
/// parts with some.
GroundHeights ground_heights(const Cloud& cloud, const VolumeGrid& grid, uint32_t min_points,
                             Task& task);

}  // namespace jalon
