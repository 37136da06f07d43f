// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "base/task.h"
#include "registration/coarse/surface.h"

namespace jalon {

/// A point of the moving surface and one of the reference that may be the same place.
struct FeatureMatch {
  uint32_t moving, reference;
  float distance;  ///< of the features
};

/// Pairs of distinct points each of which is among the `rank` nearest in feature space of the
/// other.
///
/// Before: features are described. After: the nearest first, ties by index, at most `most`; a point
/// may stand in several. O(a b) for a and b distinct points.
std::vector<FeatureMatch> match_features(const CoarseSurface& reference,
                                         const CoarseSurface& moving, size_t rank, size_t most,
                                         Task& task);

}  // namespace jalon
