// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "segment/ransac/extraction.h"

namespace jalon {

/// Each surface k - 1 the points that scene.owner gives to k, ascending.
void take_positions(const SegmentScene& scene, std::vector<Surface>& surfaces, Task& task);

/// A point that changed hands between surfaces; owners as in scene.owner, 0 = none.
struct MovedPoint {
  uint32_t position, before, now;
};

/// The same as take_positions() where only these points moved since: in parts that ascend, and so do the parts. In the
/// time that the surfaces take which have such points.
void move_positions(const std::vector<std::vector<MovedPoint>>& moves,
                    std::vector<Surface>& surfaces, Task& task);

}  // namespace jalon
