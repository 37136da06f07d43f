// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

#include "formats/las/plan.h"

namespace jalon::las {

/// What the header says about the points; sums and extremes, so the order of chunks does not
/// matter.
struct Tally {
  std::array<int64_t, 3> min{std::numeric_limits<int64_t>::max(),
                             std::numeric_limits<int64_t>::max(),
                             std::numeric_limits<int64_t>::max()};
  std::array<int64_t, 3> max{std::numeric_limits<int64_t>::min(),
                             std::numeric_limits<int64_t>::min(),
                             std::numeric_limits<int64_t>::min()};
  std::array<uint64_t, 16> by_return{};

  Tally& operator+=(const Tally& b) {
    for (size_t k = 0; k < 3; ++k) {
      min[k] = std::min(min[k], b.min[k]);
      max[k] = std::max(max[k], b.max[k]);
    }
    for (size_t k = 0; k < by_return.size(); ++k) by_return[k] += b.by_return[k];
    return *this;
  }
};

/// A coordinate of the cloud as the file's integer; the plan made sure that it fits.
inline int32_t steps_of(const Plan& plan, double metres, int axis) {
  const double unit = axis == 2 ? plan.units.vertical : plan.units.horizontal;
  return static_cast<int32_t>(
      std::nearbyint((metres / unit - plan.offset[axis]) / plan.scale[axis]));
}

/// Points [first, first + n) as records, one behind the other.
Tally put_points(const Plan& plan, const Cloud& cloud, std::byte* records, size_t first, size_t n);
/// These points.
Tally put_points(const Plan& plan, const Cloud& cloud, std::byte* records,
                 std::span<const uint32_t> points);

}  // namespace jalon::las
