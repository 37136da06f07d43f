// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/volumes/grid_points.h"

#include <algorithm>

#include "base/parallel.h"

namespace jalon {

namespace {

constexpr size_t kGridPointGrain = 1 << 15;

}  // namespace

GridPoints::GridPoints(const Cloud& cloud, const VolumeGrid& grid, Task& task)
    : cloud_(cloud), grid_(grid), first_(grid.cells() + 1) {
  const size_t n = cloud.size();
  Buffer<uint32_t> cell(n);
  parallel_for(task, n, kGridPointGrain, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i)
      cell[i] = static_cast<uint32_t>(grid.cell_of(grid.project(cloud.point(i))));
  });
  std::fill(first_.begin(), first_.end(), 0u);
  for (size_t i = 0; i < n; ++i) {
    if (i % kGridPointGrain == 0) task.checkpoint(0.3);
    ++first_[cell[i] + 1];
  }
  for (size_t c = 0; c < grid.cells(); ++c) first_[c + 1] += first_[c];
  order_ = Buffer<uint32_t>(n);
  Buffer<uint32_t> next(grid.cells());
  std::copy(first_.begin(), first_.end() - 1, next.begin());
  for (size_t i = 0; i < n; ++i) {
    if (i % kGridPointGrain == 0) task.checkpoint(0.5);
    order_[next[cell[i]]++] = static_cast<uint32_t>(i);
  }
}

}  // namespace jalon
