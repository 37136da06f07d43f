// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "cloud/cloud.h"
#include "segment/codes/coded_object.h"

namespace jalon {

/// Which of equal steps from low on a coordinate lies in, those beyond either end in the last one there.
inline size_t plan_step(double at, double low, double step, size_t steps) {
  const double k = (at - low) / step;
  return k > 0 ? std::min(static_cast<size_t>(k), steps - 1) : 0;
}

/// The points of a cloud by tiles of its plan, 4 bytes a point: what is near a place of a list is found without a pass
/// through the cloud.
class PlanTiles {
 public:
  /// Places are relative to origin.
  PlanTiles(const Cloud& cloud, const Vec3& origin, Task& task);

  /// Indices, ascending, of the points of all tiles that a circle in plan meets.
  std::vector<uint32_t> points_about(const Vec2& place, double radius_m) const {
    return points_about(place, radius_m, [](uint32_t) { return true; });
  }
  /// Of these the ones that keep(index) takes, in no order before they are kept: of the tiles about a facade most are
  /// not near its plane.
  template <class Keep>
  std::vector<uint32_t> points_about(const Vec2& place, double radius_m, Keep&& keep) const {
    std::vector<uint32_t> out;
    for_rows_about(place, radius_m, [&](std::span<const uint32_t> members) {
      for (const uint32_t i : members)
        if (keep(i)) out.push_back(i);
    });
    std::sort(out.begin(), out.end());
    return out;
  }

 private:
  /// The members of the tiles that a circle meets, row by row.
  template <class F>
  void for_rows_about(const Vec2& place, double radius_m, F&& f) const {
    if (columns_ == 0) return;
    const auto step = [&](double at, double low, size_t steps) {
      return plan_step(at, low, tile_m_, steps);
    };
    const size_t left = step(place.u - radius_m, low_.u, columns_),
                 right = step(place.u + radius_m, low_.u, columns_),
                 top = step(place.v + radius_m, low_.v, rows_);
    for (size_t row = step(place.v - radius_m, low_.v, rows_); row <= top; ++row) {
      const uint64_t from = first_[row * columns_ + left], to = first_[row * columns_ + right + 1];
      f(std::span(members_).subspan(from, to - from));
    }
  }
  size_t tile_of(const Vec3& p) const;

  Vec2 low_;
  double tile_m_ = 1;
  size_t columns_ = 0, rows_ = 0;
  std::vector<uint64_t> first_;  ///< of each tile among members_, and their number
  std::vector<uint32_t> members_;
};

}  // namespace jalon
