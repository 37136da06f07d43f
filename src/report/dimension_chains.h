// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "geometry/vec.h"

namespace jalon {

/// Upright box of an opening on the drawing, metres.
struct OpeningBox {
  Vec2 low, high;
};

/// What a drawing dimensions: places along x or z, ascending, between which the distances are written. Empty: nothing
/// to write.
struct Dimensions {
  std::vector<double> columns;  ///< the sides of the openings, column by column, from end to end of the facade
  std::vector<double> axes;     ///< the middles of these columns
  std::vector<double> ground_floor;  ///< columns of the lowest row, where they are others
  std::vector<double> rows;     ///< sills and heads
  std::vector<double> levels;   ///< heights for marks, the most wanted first
};

/// Openings that stand above or beside each other share a column or row when their sides agree within the tolerance:
/// what repeats is written once, with its mean place. Where columns overlap (doors under windows of another width) the
/// more frequent one counts. long_boxes: cornices and string courses, for the levels.
Dimensions find_dimensions(std::span<const OpeningBox> openings, std::span<const OpeningBox> long_boxes,
                           const OpeningBox& facade, double ground_m, double tolerance_m);

}  // namespace jalon
