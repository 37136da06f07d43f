// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>

#include "segment/codes/coded_object.h"

namespace jalon {

/// Two opposite corners of an opening at its frame.
struct OpeningCorners {
  Vec3 a, b;
  std::string fault;    ///< "" or why there are none
  size_t fault_at = 0;  ///< number of the point that is to blame
};

/// From two corners at the frame; or three points, one of them offset: the recessed twin of the corner straight before
/// it; or four, lower corners 1 and 2 at the wall, the recessed twin of 2 and the recessed upper corner above it. The
/// step from a corner to its twin moves the other corner to the frame (reduction of 3 or 4 points to 2).
OpeningCorners opening_corners(std::span<const CodedPoint> points, int64_t offset_modifier);

}  // namespace jalon
