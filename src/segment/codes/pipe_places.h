// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "cloud/cloud.h"
#include "geometry/circle.h"
#include "segment/codes/coded_object.h"

namespace jalon {

/// Of a pipe's radius, behind its axis as seen from its wall: where the side begins that nobody sees.
inline constexpr double kPipeBackShare = 0.25;

/// Where the cloud has an upright pipe.
struct PipePlace {
  size_t object = 0;  ///< index
  Circle circle;      ///< in plan, relative to the objects' origin
  double off_m = 0;   ///< from the surveyed axis
};

/// The upright pipes about whose axis the cloud's points lie on a circle of about the surveyed size, up to 6 cm off: a
/// robust fit in plan of the points between foot and top. Ascending by object.
std::vector<PipePlace> pipe_places(const Cloud& cloud, const CodedObjects& objects, Task& task);

}  // namespace jalon
