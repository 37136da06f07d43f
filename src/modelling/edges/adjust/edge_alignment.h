// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "modelling/edges/adjust/edge_blocks.h"

namespace jalon {

/// Brings weak edges of a plane onto the lines of better ones, as a draughtsman does: exactly
/// vertical or horizontal edges with the solid on the same side that lie in one line within their
/// standard deviations get its weighted mean, the best measured ones first. An edge measured well
/// keeps to itself where it differs.
///
/// After: edges brought together have the same coordinate; arcs and slanted edges are as they were.
/// O(n^2) in lines that are near.
void align_edges(std::span<MeasuredEdge* const> edges, double spacing_m);

}  // namespace jalon
