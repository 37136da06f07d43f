// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "registration/targets/solution.h"

namespace jalon {

/// Ways to pair targets, all with the same number of pairs, in a fixed order.
struct Matching {
  std::vector<std::vector<IndexPair>> ways;
  bool complete = true;  ///< false: there are more, or too many alike to search through
};

/// Pairs by distances: two pairs agree when the distances of their targets are the same within the
/// match tolerance (for a similarity: have the same ratio); the largest sets of pairs that all
/// agree are the ways. named: pairs that are known; to them are added those of the other targets of
/// which one at least has no name. kLimit for more targets than can be matched.
///
/// After: each way begins with the named pairs, has three pairs or more, and uses a target once;
/// none where no three agree. Deterministic.
Matching match_by_distances(const TargetSets& sets, std::span<const IndexPair> named,
                            const TargetSettings& setting, Task& task);

}  // namespace jalon
