// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <vector>

#include "registration/coarse/candidates.h"
#include "registration/coarse/pose.h"

namespace jalon {

/// A pose, where it came from, and what it lays onto each other.
struct RankedPose {
  Transform T_reference_moving;  ///< between the surfaces' own frames
  PoseSource source = PoseSource::kFeatures;
  SurfaceOverlap overlap;
};

struct CoarseSearch {
  std::vector<RankedPose> poses;  ///< clearly different from each other, the best first
  Square<6> fixed{};              ///< normal equations of the best about the moving centroid
};

/// Which poses are wanted at all; of poses between the surfaces' own frames.
using PoseFilter = std::function<bool(const Transform&)>;

/// 1. The overlap of all candidates on few points.
/// 2. The best of them settled by point-to-plane iterations and judged on more.
/// 3. The best moved along what holds it least and settled again, so that a corridor shows that it
///    is one.
/// 4. What remains different, on all points.
///
/// After: every pose is wanted, lays no surface across the other, and lies at least four cells from
/// each better one; none where no candidate stands. Same bits for any number of threads.
CoarseSearch search_poses(const CoarseSurface& reference, const CoarseSurface& moving,
                          const std::vector<PoseCandidate>& candidates, const PoseFilter& is_wanted,
                          Task& task);

}  // namespace jalon
