// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <compare>
#include <cstdint>
#include <vector>

#include "geometry/vec.h"

namespace jalon {

/// Points by cells of the plan, about as wide as a strip. Made in O(n log n).
class PointCells {
 public:
  explicit PointCells(const std::vector<Vec3>& at) {
    for (uint32_t i = 0; i < at.size(); ++i)
      cells_.push_back({cell_of(at[i].x), cell_of(at[i].y), i});
    std::sort(cells_.begin(), cells_.end());
  }
  /// Calls f(i) for each point of the cells that the box meets, in the order of the cells.
  template <class F>
  void each(const Vec2& low, const Vec2& high, F&& f) const {
    for (int64_t x = cell_of(low.u); x <= cell_of(high.u); ++x) {
      const Entry first{x, cell_of(low.v), 0};
      for (auto at = std::lower_bound(cells_.begin(), cells_.end(), first);
           at != cells_.end() && at->x == x && at->y <= cell_of(high.v); ++at)
        f(at->point);
    }
  }

 private:
  static constexpr double kCell_m = 2;
  struct Entry {
    int64_t x = 0, y = 0;
    uint32_t point = 0;
    auto operator<=>(const Entry&) const = default;
  };
  static int64_t cell_of(double v) { return static_cast<int64_t>(std::floor(v / kCell_m)); }
  std::vector<Entry> cells_;
};

}  // namespace jalon
