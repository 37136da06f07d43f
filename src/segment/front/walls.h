// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "segment/segmentation.h"

namespace jalon {

/// A wall whose viewer is asked for. Indices of segments.
struct WallGroup {
  size_t main = 0;                 ///< its largest plane
  std::vector<size_t> members;     ///< in one plane with the main one, which is the first
  std::vector<size_t> attendants;  ///< smaller, parallel and near: panes, bands, balconies
};

/// Of directions within 10 degrees.
constexpr double kSameDirection = 0.985;

bool is_upright(const Segment& segment);

/// Groups by falling area of their main planes. O(groups x segments).
std::vector<WallGroup> wall_groups(const std::vector<Segment>& segments);

}  // namespace jalon
