// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>
#include <span>

#include "base/buffer.h"
#include "base/task.h"
#include "cloud/cloud.h"
#include "compare/volumes/kept_blocks.h"
#include "geometry/vec.h"

namespace jalon {

/// Square cells across a direction. Heights are counted along it from the origin, a whole metre.
struct VolumeGrid {
  Vec3 origin;
  Vec3 u{1, 0, 0}, v{0, 1, 0},
      up{0, 0, 1};  ///< along columns, along rows, the direction; right-handed
  double cell_m = 1;
  double first_u = 0, first_v = 0;  ///< where column and row 0 begin; whole cells from the origin
  uint32_t columns = 0, rows = 0;   ///< that are kept, as cells are numbered
  KeptBlocks kept_columns, kept_rows;  ///< of all (without_empty_blocks)

  size_t cells() const { return size_t{columns} * rows; }
  /// With those that are left out.
  size_t all_cells() const {
    return (size_t{columns} + kept_columns.left_out()) * (size_t{rows} + kept_rows.left_out());
  }
  /// Numbers among all columns and all rows.
  uint32_t column_of(size_t cell) const {
    return kept_columns.cell_of(static_cast<uint32_t>(cell % columns));
  }
  uint32_t row_of(size_t cell) const {
    return kept_rows.cell_of(static_cast<uint32_t>(cell / columns));
  }
  /// (along u, along v, height), relative to the origin.
  Vec3 project(const Vec3& p) const {
    const Vec3 local = p - origin;
    return {dot(local, u), dot(local, v), dot(local, up)};
  }
  /// Of a projected point inside the grid's box, of the clouds whose empty blocks were left out.
  size_t cell_of(const Vec3& projected) const;
  /// Centre of a cell at this height, in world coordinates.
  Vec3 place(size_t cell, double height) const;
};

/// The grid over a box of projected points; the number of cells is bounded (kLimit). The grid given has its axes.
VolumeGrid grid_over(VolumeGrid axes, const Box3& projected, double cell_m);
/// The grid for the points of both clouds; where it has far more cells than they have points, without the blocks of
/// columns and of rows that lie far from all of them.
VolumeGrid without_empty_blocks(VolumeGrid grid, const Cloud& first, const Cloud& second,
                                Task& task);
/// Axes and origin for what lies in both boxes (world coordinates). Throws kInvalidArgument unless
/// the direction has three numbers and a length.
VolumeGrid volume_axes(const Box3& first, const Box3& second, std::span<const double> direction);

/// Heights of one state, one a cell.
struct CellHeights {
  Buffer<double> height;    ///< NaN without data
  Buffer<double> variance;  ///< of the height; 0 where it is not known
  Buffer<uint32_t> points;
  explicit CellHeights(size_t cells) : height(cells), variance(cells), points(cells) {}
};

enum class CellValue { kMean, kMedian, kInterpolated };

/// Heights of a cloud: mean or median of each cell's points; or the plane through the points of the cell and of the
/// eight around it, at the cell's centre, which takes out that points lie unevenly on a slope, and gives cells without
/// points a height when five of those around have some.
CellHeights cloud_heights(const Cloud& cloud, const VolumeGrid& grid, CellValue value, Task& task);

}  // namespace jalon
