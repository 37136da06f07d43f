// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/task.h"
#include "segment/segmentation.h"

namespace jalon {

/// Signed distances of the points to their own planes, in bins. Noise points (NaN) are left out.
struct Residuals {
  uint64_t count = 0;
  double mean_m = 0, sigma_m = 0;    ///< sigma: root of the mean square about the mean
  double half_range_m = 0.001;       ///< bins cover [-half_range, half_range]
  uint64_t below = 0, above = 0;     ///< outside the bins
  std::vector<uint64_t> bins;
};

/// The range is four sigma, rounded up. Same bits for any number of threads.
Residuals bin_residuals(const Segmentation& segmentation, size_t bins, Task& task);

/// Histogram as SVG: millimetres across, points upward, and the normal curve of the same mean, sigma and count.
std::string residual_chart(const Residuals& residuals);

}  // namespace jalon
