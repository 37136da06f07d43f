// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/cholesky.h"
#include "modelling/edges/adjust/edge_density.h"

namespace jalon {

struct EdgeSetting {
  double spacing_m = 0.01;
  double sigma_m = 0.003;  ///< noise of the points across the plane
  double window_m = 0.01;  ///< half-thickness of what counts as on the plane
  bool reveals = true;     ///< look for surfaces that meet the plane at the edge
  double snap_rad = 0.05;  ///< lines that turn out this near to vertical or horizontal become so
};

/// Corrections of an edge and their information (inverse covariance): of a line across at its middle and its slope; of
/// an arc its centre u, v and radius.
using EdgeInformation = Square<3>;

/// Moves an edge to where the density of the plane's points begins and the points of its reveals
/// say.
/// 1. What the reveals say of it, and then what the density says (edge_reveal.h, edge_density.h).
/// 2. The two agree, and are averaged by their variances, or the reveal wins if it has many points.
/// 3. Corrections of place and slope, or of centre and radius, by least squares.
/// 4. Lines of a snapped direction keep it, others may be snapped now (EdgeShape::snap).
///
/// Before: blocks and reveal points are those about the edge as it is (collect_blocks). After:
/// sigma is finite, source says what told the place, moved_m has grown by the step; an edge about
/// which nothing was measured has only got the sigma of contour points. Returns the information
/// about the edge as it now is.
EdgeInformation adjust_edge(const EdgeSetting& setting, const CountingVariance& variance,
                            MeasuredEdge& edge);

/// Moves an edge to where its reveals alone say, where they say anything: its own points may end elsewhere, as those
/// of a wall about an opening with a surround do. Before, after: as adjust_edge.
void move_to_reveal(const EdgeSetting& setting, MeasuredEdge& edge);

}  // namespace jalon
