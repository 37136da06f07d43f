// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "geometry/circle.h"
#include "geometry/vec.h"
#include "modelling/edges/find/edge_line.h"
#include "modelling/edges/find/guide_lines.h"

namespace jalon {

/// A straight or curved part of a closed chain (Boulaassal 2010, 4.3.1): its points first ... first + count - 1, walked
/// round the chain; neighbours share the point between them.
struct ChainPart {
  size_t first = 0, count = 0;
  bool is_arc = false;
  bool is_guided = false;  ///< a straight part on a line given
  EdgeLine line;           ///< of straight parts, along the chain
  Circle circle;           ///< of curved parts
  double turn = 0;         ///< of curved parts: 1 = anticlockwise, -1 = clockwise
};

struct PartsSetting {
  double spacing_m = 0.01;  ///< of the points of the segment
  bool arcs = true;         ///< false: lines only
  /// Lines (of true edges: set_back_m outside the contour points) that parts may lie on at the price of the cut alone.
  const GuideLines* guides = nullptr;
  double set_back_m = 0;
  double bridge_m =
      0;  ///< with guides: the triangulation cuts corners by single steps up to so long
};

/// The parts that explain the chain best: least sum of squared distances over the variance of
/// contour points, plus what each part costs by its number of parameters (Schwarz 1978), over all
/// ways to cut the chain at its candidate corners (dynamic programming), the cuts then moved point
/// by point. A line wins wherever an arc explains no more than its third parameter costs. With
/// guides, a part that lies on one of them has no parameters of its own, and single steps between
/// parts that cut the corner where these meet are no parts.
///
/// Before: chain closed, 3 points or more, none twice in a row. After: the parts follow each other
/// round the chain, every point is in one, and those between two in both. O(n log n + c l) for c
/// candidates and l of them in the longest part.
std::vector<ChainPart> split_chain(std::span<const Vec2> chain, const PartsSetting& setting);

}  // namespace jalon
