// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/task.h"
#include "geometry/plane.h"
#include "segment/profiles/slices.h"

namespace jalon {

/// Between two lines of neighbouring slices that may lie in one plane.
struct ProfileRectangle {
  uint32_t low = 0, high = 0;  ///< places of the lines
  PlaneFit fit;                ///< of the points of both
};

/// What makes lines a rectangle and rectangles a plane.
struct RectangleRule {
  double step_m = 0;     ///< between slices
  double angle_rad = 0;  ///< between two lines, and between a rectangle and its set's plane
  double tolerance_m =
      0;  ///< twice the rms of a line's points from its rectangle, and from its set's plane
};

/// Each line with the one of the next slice that runs beside it at the least distance, and the other way round: the
/// direction agrees, they overlap by half the shorter, the plane through both is no flatter than 50 degrees to the
/// axis. lines: slice by slice.
std::vector<ProfileRectangle> match_lines(std::span<const ProfileLine> lines,
                                          const RectangleRule& rule, Task& task);

/// Lines of one plane.
struct ProfileSet {
  std::vector<uint32_t> lines;  ///< places, ascending
  Moments moments;              ///< of those that lie well in it: the others lead on to more of it
};

/// Sets of rectangles that share lines and lie in one plane, grown from the largest with running moments, where they
/// show in three slices. What lies between two slices only is a detail, or chance: from a wall to the windows set back
/// in it, over which no chain of rectangles may lead from plane to plane.
std::vector<ProfileSet> join_rectangles(std::span<const ProfileLine> lines,
                                        std::span<const ProfileRectangle> rectangles,
                                        const RectangleRule& rule, Task& task);

}  // namespace jalon
