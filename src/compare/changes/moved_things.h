// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "compare/changes/change_groups.h"

namespace jalon {

/// The points of two planes that share none (see SurfaceCore): of fewer nothing is told. At the edges of pipes chance
/// leaves fewer.
constexpr size_t kLeastToldPoints = 64;

struct MovedThings {
  std::vector<Change> moved;   ///< more likely than not
  std::vector<Change> others;  ///< motions that were weighed and not taken
};

/// Motions that explain groups of changed points: 1. of each group the whole thing that it is a part of; 2. of two
/// groups, one gone and one come within reach (in sizes of the larger), the thing that both are parts of, or they
/// alone; 3. each motion has its probability; the most probable is taken first, with all groups that lie in its
/// thing, as long as one is more likely than not. What is taken leaves the groups.
MovedThings take_moved_things(const ObjectMotionJob& job, double reach,
                              std::vector<ChangeGroup>& groups);

}  // namespace jalon
