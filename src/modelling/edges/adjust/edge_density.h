// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>
#include <vector>

#include "modelling/edges/adjust/edge_blocks.h"

namespace jalon {

/// A measured distance of the true edge from the assumed one, into the solid, at one place along it.
struct EdgeOffset {
  double t_m = 0, offset_m = 0;
  double weight = 0;  ///< 1 / variance, of what is independent of the other places
};

/// Variance of an edge's place by counting, for an edge of length l: along / l + common. Points at random have only the
/// first term; the rows of a grid along an edge leave the second, a twelfth of their distance squared.
struct CountingVariance {
  double along_m3 = 0, common_m2 = 0;
  double of(double length_m) const { return along_m3 / length_m + common_m2; }
};

/// Offsets by the density of points, one a block: counted from the assumed edge inward, the points
/// begin where a solid of the density found further in begins. Points count 1 up to a quarter
/// spacing inside and fade out over two spacings behind that, so that the rows of a grid leave no
/// trace; a symmetric blur of the edge leaves none either. extra_per_m: points a metre of edge that
/// lie on the plane at the edge but are no solid (a reveal's first ones). After: in the order of
/// the blocks, none of a block with too few points.
std::vector<EdgeOffset> density_offsets(const MeasuredEdge& edge, double spacing_m,
                                        double extra_per_m, const CountingVariance& variance);

/// What counting is worth on these edges: the same count at many places inside the solid, where there is no edge.
/// Edges of one direction class, for a grid treats them alike. Without enough of them the variance of random points.
/// sigma_m: noise of the points across the plane, which bounds that along it.
CountingVariance counting_variance(std::span<const MeasuredEdge* const> edges, double spacing_m,
                                   double sigma_m);

}  // namespace jalon
