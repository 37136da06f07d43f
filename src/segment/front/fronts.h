// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "base/task.h"
#include "segment/front/evidence.h"
#include "segment/front/wall_sheet.h"

namespace jalon {

/// From which side a wall was seen.
struct WallFront {
  WallGroup group;
  FrontEvidence evidence;  ///< before: where the main plane's normal points to
  double log_odds = 0;     ///< for that side
  Vec3 viewer;  ///< before the wall's middle on the likelier side, in the segments' frame

  bool is_before() const { return log_odds >= 0; }
  double confidence() const;  ///< 0.5 to 1: the probability of the likelier side
};

/// Walls of a cloud without stations: where their viewer stood, by what lies about them. origin: of the segments'
/// frame.
/// 1. walls in one plane, with what is parallel and near (walls.h);
/// 2. what lies on both sides of each (near_wall.h, free_space.h);
/// 3. the odds of each alone (side.h);
/// 4. who saw one of them sees others too (shared_viewers.h).
/// O(points x groups).
std::vector<WallFront> wall_fronts(const Cloud& cloud, const Vec3& origin,
                                   std::span<const uint32_t> labels,
                                   const std::vector<Segment>& segments, Task& task);

}  // namespace jalon
