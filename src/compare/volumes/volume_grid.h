// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>
#include <span>

#include "base/buffer.h"
#include "base/task.h"
#include "cloud/cloud.h"
#include "geometry/vec.h"

namespace jalon {

/// Square cells across a direction. Heights are counted along it from the origin, a whole metre.
struct VolumeGrid {
  Vec3 origin;
  Vec3 u{1, 0, 0}, v{0, 1, 0},
      up{0, 0, 1};  ///< along columns, along rows, the direction; right-handed
  double cell_m = 1;
  double first_u = 0, first_v = 0;  ///< where column and row 0 begin; whole cells from the origin
  uint32_t columns = 0, rows = 0;

  size_t cells() const { return size_t{columns} * rows; }
  /// (along u, along v, height), relative to the origin.
  Vec3 project(const Vec3& p) const {
    const Vec3 local = p - origin;
    return {dot(local, u), dot(local, v), dot(local, up)};
  }
  /// Of a projected point inside the grid's box.
  size_t cell_of(const Vec3& projected) const;
  /// Centre of a cell at this height, in world coordinates.
  Vec3 place(size_t cell, double height) const;
};

/// The grid over a box of projected points; the number of cells is bounded (kLimit). The grid given has its axes.
VolumeGrid grid_over(VolumeGrid axes, const Box3& projected, double cell_m);
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
