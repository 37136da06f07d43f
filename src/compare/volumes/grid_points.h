// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "base/buffer.h"
#include "cloud/cloud.h"
#include "compare/volumes/volume_grid.h"

namespace jalon {

/// The points of each cell of a grid, in their order. The cloud and the grid outlive it; the grid holds all points.
class GridPoints {
 public:
  GridPoints(const Cloud& cloud, const VolumeGrid& grid, Task& task);

  uint32_t count(size_t cell) const { return first_[cell + 1] - first_[cell]; }
  /// f(projected point) of each.
  template <class F>
  void for_each(size_t cell, F&& f) const {
    for (uint32_t k = first_[cell]; k < first_[cell + 1]; ++k)
      f(grid_.project(cloud_.point(order_[k])));
  }

 private:
  const Cloud& cloud_;
  const VolumeGrid& grid_;
  Buffer<uint32_t> first_, order_;
};

}  // namespace jalon
