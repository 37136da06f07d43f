// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/codes/plan_tiles.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"

namespace jalon {

namespace {

constexpr double kTile_m = 0.5;      // about a window
constexpr double kMostTiles = 1024;  // along a side: 8 MB of them at most
constexpr size_t kTilePointsPerChunk = 1 << 16;

// Coordinates may differ by more than a double holds.
size_t steps_over(double size, double step) {
  return std::isfinite(step) ? static_cast<size_t>(size / step) + 1 : 1;
}

}  // namespace

PlanTiles::PlanTiles(const Cloud& cloud, const Vec3& origin, Task& task) {
  const Box3 box = bounds(cloud, task);
  low_ = in_plan(box.min - origin);
  const Vec2 size = in_plan(box.max - box.min);
  tile_m_ = std::max(kTile_m, std::max(size.u, size.v) / kMostTiles);
  columns_ = steps_over(size.u, tile_m_);
  rows_ = steps_over(size.v, tile_m_);
  const size_t n = cloud.size();
  std::vector<uint32_t> tile(n);
  parallel_for(task, n, kTilePointsPerChunk, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i)
      tile[i] = static_cast<uint32_t>(tile_of(cloud.point(i) - origin));
  });
  first_.assign(columns_ * rows_ + 1, 0);
  for (const uint32_t t : tile) ++first_[t + 1];
  for (size_t t = 0; t < columns_ * rows_; ++t) first_[t + 1] += first_[t];
  members_.resize(n);
  std::vector<uint64_t> next(first_.begin(), first_.end() - 1);
  for (size_t i = 0; i < n; ++i) members_[next[tile[i]]++] = static_cast<uint32_t>(i);
}

size_t PlanTiles::tile_of(const Vec3& p) const {
  return plan_step(p.y, low_.v, tile_m_, rows_) * columns_ +
         plan_step(p.x, low_.u, tile_m_, columns_);
}

}  // namespace jalon
