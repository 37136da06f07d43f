// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "cloud/cloud.h"
#include "modelling/evidence/opening_shape.h"
#include "modelling/evidence/wall_cells.h"

namespace jalon {

/// The points that a wall's cells were made of; none: bars are measured by their cells.
struct WallPoints {
  const Cloud* cloud = nullptr;
  std::span<const uint32_t> indices;
};

inline constexpr double kMullion_m = 0.2;    ///< wider are piers
inline constexpr double kMostLight_m = 1.3;  ///< of the narrower light

/// Lights of one window as one shape: rectangles side by side (or one over the other) of the same foot and head (left
/// and right), parted by a mullion (a transom) narrower than any pier. Where the wall's own points go on between them,
/// from foot to head and as broad as half a brick, they are two windows, if it also goes on beside the row of lights,
/// broader than that: panels between the posts of a timber frame are none. The shapes are in these cells; borders lie
/// within one of the truth. O(points) where lights meet.
std::vector<OpeningShape> joined_lights(std::vector<OpeningShape> shapes, const WallCells& cells,
                                        const WallPoints& points = {});

}  // namespace jalon
