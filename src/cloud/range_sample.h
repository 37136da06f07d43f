// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

#include "base/numbers.h"
#include "cloud/cloud.h"
#include "geometry/plane.h"

namespace jalon {

/// Range precision on a flat sample (Boulaassal 2010, 5.7).
struct RangeSample {
  PlaneFit fit;                  ///< sigma divided by n - 3
  double range_precision_m = 0;  ///< s_d, divided by n - 1
  double mean_intensity = kNaN;
  double std_intensity = kNaN;  ///< divided by n - 1
};

/// indices: none = all points.
RangeSample range_sample(const Cloud& cloud, std::span<const uint64_t> indices, Task& task);

}  // namespace jalon
