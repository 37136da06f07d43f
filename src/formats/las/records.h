// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

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

/// Points [first, first + n) as records, one behind the other.
Tally put_points(const Plan& plan, const Cloud& cloud, std::byte* records, size_t first, size_t n);

}  // namespace jalon::las
