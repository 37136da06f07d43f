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

/// Where openings of one column or row begin and end, and how many share it.
struct OpeningInterval {
  double from = 0, to = 0;
  size_t count = 1;
};

/// Openings clear of each other, ascending, between the ends of the facade.
struct OpeningChain {
  std::vector<OpeningInterval> openings;
  double from = 0, to = 0;
  double tolerance_m = 0;  ///< sides nearer to each other than this are one

  /// Places between which the distances are written, from end to end; empty without openings.
  std::vector<double> sides() const;
  std::vector<double> axes() const;
  void drop_narrowest();
};

/// What a drawing dimensions along x and z.
struct Dimensions {
  OpeningChain columns;
  OpeningChain ground_floor;   ///< columns of the lowest row, where they are others
  OpeningChain rows;           ///< sills and heads
  std::vector<double> axes;    ///< the middles of the columns
  std::vector<double> levels;  ///< heights for marks, the most wanted first
};

/// Openings that stand above or beside each other share a column or row when their sides agree within the tolerance:
/// what repeats is written once, with its mean place. Where columns overlap (doors under windows of another width) the
/// more frequent one counts. long_boxes: cornices and string courses, for the levels.
Dimensions find_dimensions(std::span<const OpeningBox> openings,
                           std::span<const OpeningBox> long_boxes, const OpeningBox& facade,
                           double ground_m, double tolerance_m);

}  // namespace jalon
