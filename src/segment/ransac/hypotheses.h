// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "segment/ransac/curved.h"
#include "segment/ransac/orientation_pass.h"
#include "segment/ransac/point_pool.h"

namespace jalon {

/// A surface that a few points suggest and their surroundings support, with what is known of its score (its number of
/// inliers).
struct Candidate {
  Plane plane;          ///< local frame
  Curved curved;        ///< a sphere or cylinder instead of the plane, where it exists
  uint32_t seed = 0;    ///< position of the first point drawn
  uint32_t found = 0;   ///< inliers in the pieces looked at
  uint32_t pieces = 0;  ///< pieces looked at
  uint32_t epoch = 0;   ///< state of the pool when it was scored
  double lower = 0, upper = 0, estimate = 0;  ///< of the score
};

/// Draw number `draw` (steps in hypotheses.cpp); false when it gives no plane that its surroundings support, as always
/// where no point is free.
bool draw_candidate(const RansacScene& scene, const PointPool& pool, const OrientationPass& pass,
                    uint64_t draw, Candidate& out);

/// Looks at the next piece and narrows the bounds; large pieces by all threads, where they are free.
void score_next_piece(const SegmentScene& scene, const PointPool& pool, Candidate& candidate,
                      Task& task);
/// Looks at pieces until the bounds are narrow, or the score is sure to stay below min_points.
void score_roughly(const SegmentScene& scene, const PointPool& pool, Candidate& candidate,
                   Task& task);

}  // namespace jalon
