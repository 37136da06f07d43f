// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "modelling/edges/adjust/edge_blocks.h"

namespace jalon {

/// Rows of points along edges: how far apart, and how plainly (1: all points on their row; 0: no rows).
struct Rows {
  double distance_m = 0, visibility = 0;
};

/// The strongest period of the points' depths, by their Fourier sums block by block, so that rows
/// that run at a small angle to the edge count too. Looks at up to 64 blocks. Before: edges of one
/// direction class, with blocks.
Rows find_rows(std::span<const MeasuredEdge* const> edges, double spacing_m);

}  // namespace jalon
