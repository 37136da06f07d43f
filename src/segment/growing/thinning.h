// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "segment/growing/points.h"

namespace jalon {

/// Free points, one of each occupied cell, and where in the scene's order the cells begin.
struct Representatives {
  std::vector<uint32_t> points, first;
  size_t free = 0;
};

/// The middle one of a cell's free points (the first would lie on the low side of the noise); cells have about the
/// tolerance as edge.
Representatives one_per_cell(const SegmentScene& scene, Task& task);
/// True when the representatives are so few that a tree of theirs is worth its cost.
bool pays(const Representatives& cells);
/// A tree over the representatives where that pays, else over the free points; no more of GrowingPoints.
GrowingPoints thinned_points(const SegmentScene& scene, const Representatives& cells, Task& task);

}  // namespace jalon
