// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <span>

#include "base/field.h"
#include "base/task.h"
#include "spatial/octree/octree.h"

namespace jalon {

/// Predicted sampling error of nearest-point distances (Girardeau-Montaut 2006, 2.4-2.6, with the mean corrected): on
/// an unchanged plane of lambda random reference points a unit of area, the root mean square distance is
/// 1 / sqrt(pi lambda) and the mean 1 / (2 sqrt(lambda)).
struct SamplingError {
  std::shared_ptr<Column>
      column;  ///< "sampling_error", a row a compared point; NaN where there is no reference
  double rms_m = 0, mean_m = 0;  ///< expected of all compared points together, NaN without any
};

/// nearest: for every compared point, in the caller's order, its reference point or kNoPoint. The density is that of
/// the reference around it.
SamplingError predict_sampling_error(const Octree& reference, std::span<const uint32_t> nearest,
                                     Task& task);

}  // namespace jalon
