// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <span>
#include <vector>

#include "modelling/edges/find/chain_moments.h"
#include "modelling/edges/find/chain_parts.h"

namespace jalon {

/// What parts of a closed chain cost (chain_parts.h): least squares over the variance of contour points, and their
/// parameters (Schwarz 1978).
struct PartCosts {
  std::span<const Vec2> chain;
  const PartsSetting& setting;
  ChainMoments moments;
  std::vector<double> way_m;  ///< from the first point to each, twice round
  double variance, line_cost, arc_cost, cut_cost;

  PartCosts(std::span<const Vec2> points, const PartsSetting& s);
  // A division costs more than what is done with the point.
  const Vec2& at(size_t i) const { return i < chain.size() ? chain[i] : chain[i % chain.size()]; }
};

struct PartCost {
  double cost = INFINITY;
  bool is_arc = false;
  bool is_hopeless = false;  ///< it misses its points by so much that it is not worth extending
  bool is_guided = false;
  EdgeLine guide;  ///< moved in to the contour points
};

/// Of the part from `first` to `last`, of which these are the points: the cheapest of a line, a guide and an arc.
PartCost cost_of(const PartCosts& s, const ChainMoments::Stretch& points, size_t first,
                 size_t last);
PartCost cost_of(const PartCosts& s, size_t first, size_t last);

/// Angle swept about the centre from the first over the middle to the last point; sign by sense.
double swept(const PartCosts& s, const Circle& circle, size_t first, size_t last);
/// A single long step between two parts: the triangulation's way across a corner.
bool is_bridge(const PartCosts& s, size_t first, size_t last);
double point_count(size_t first, size_t last);
/// Contour points stray together, as where a row of a grid ends beside an edge: nothing is gained by following them
/// more closely than their standard deviation.
double cost_of_misfit(const PartCosts& s, double squares, double n);
/// Whether a misfit is that of a part that is not worth extending.
bool is_hopeless(double misfit, double n);

}  // namespace jalon
