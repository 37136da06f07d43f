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
  double step_m = 0;       ///< between slices
  double angle_rad = 0;    ///< between two lines, and between the planes of two rectangles
  double tolerance_m = 0;  ///< of a rectangle's middle from the other's plane
};

/// Each line with the one of the next slice that runs beside it at the least distance, and the other way round: the
/// direction agrees, they overlap by half the shorter, the plane through both is no flatter than 50 degrees to the
/// axis. lines: slice by slice.
std::vector<ProfileRectangle> match_lines(std::span<const ProfileLine> lines,
                                          const RectangleRule& rule, Task& task);

/// Rectangles that share a line and agree, in sets that show in three slices: for each set the places of its lines,
/// ascending. What lies between two slices only is a detail, or chance: from a wall to the windows set back in it.
std::vector<std::vector<uint32_t>> join_rectangles(std::span<const ProfileLine> lines,
                                                   std::span<const ProfileRectangle> rectangles,
                                                   const RectangleRule& rule);

}  // namespace jalon
