// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "registration/targets/solution.h"

namespace jalon {

/// Which targets are the same.
struct Pairing {
  std::vector<IndexPair> pairs;
  uint64_t solutions = 1;  ///< clearly different poses that pair as many targets about as well
};

/// By name; then, where targets without a name are left on either side, by distances. Of several
/// ways the one with the least weighted squares stands, and those poses are counted that move the
/// targets elsewhere and whose residuals the covariances explain too (global test).
///
/// After: three pairs or more, each target in one at the most. kInsufficientData when no three have
/// the same distances.
Pairing pair_targets(const TargetSets& sets, const TargetSettings& setting, Task& task);

}  // namespace jalon
