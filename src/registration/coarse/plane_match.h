// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "base/task.h"
#include "registration/coarse/feature_match.h"
#include "registration/coarse/planes.h"

namespace jalon {

constexpr double kParallel = 0.9962;  ///< cosine, 5 degrees: planes that a rotation lays parallel
/// What two planes may have in common, in cells.
inline double common_area(const CoarsePlane& a, const CoarsePlane& b) {
  return static_cast<double>(std::min(a.cells, b.cells));
}

/// The planes of both surfaces, the largest first.
struct PlaneSets {
  std::span<const CoarsePlane> reference, moving;
  bool level = false;  ///< z is up in both: it counts as a plane that must be laid on itself
};

/// Rotations T_reference_moving that lay the moving planes' normals onto reference ones: from two
/// pairs of planes that stand at the same angle to each other. After: at most `most`, those that
/// lay most area onto parallel planes first, no two within a tenth of a radian; no shift in them.
std::vector<Transform> plane_rotations(const PlaneSets& planes, size_t most, Task& task);

/// The largest planes laid on each other, the surfaces' centroids on each other: both ways round,
/// in quarter turns. What is left where one plane is all there is. Eight poses, or none without
/// planes.
std::vector<Transform> poses_of_largest(const PlaneSets& planes, const CoarseSurface& reference,
                                        const CoarseSurface& moving);

/// Poses T_reference_moving with this rotation: the distances between parallel planes vote for the
/// shift across them; along a direction that no plane bounds the matches of features do. After: at
/// most `most`, the ones that bring most area together first; none where planes face fewer than two
/// ways.
std::vector<Transform> plane_poses(const Transform& rotation, const PlaneSets& planes,
                                   const CoarseSurface& reference, const CoarseSurface& moving,
                                   std::span<const FeatureMatch> matches, size_t most);

}  // namespace jalon
