// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>

#include "modelling/edges/find/edge_shape.h"
#include "modelling/plane/vector_plane.h"

namespace jalon {

/// Joins the edges of a ring, in their order round it, at nodes (Boulaassal 2010, 4.3): where lines
/// and circles of neighbours meet next to the points where their contours part; a line that passes
/// a circle by no more than the spacing touches it. Neighbours that do not meet there are joined by
/// a short edge across. reach_m: how far a node may lie from those points.
///
/// After: a ring that does not cross itself, of three corners at least (of two edges the arcs are
/// halved), its edges in the order given with the short ones between. Nothing for fewer than two
/// edges, when an edge would run backwards, or when the ring would cross itself.
std::optional<VectorRing> join_edges(std::span<const EdgeShape> edges, double spacing_m,
                                     double reach_m);

}  // namespace jalon
