// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "modelling/edges/find/edge_shape.h"
#include "modelling/plane/vector_plane.h"

namespace jalon {

/// Joins the edges of a ring, in their order round it, at nodes (facade-modelling A8-A12): where lines and circles of
/// neighbours meet next to the points where their contours part; a line that passes a circle by no more than the
/// spacing touches it. Neighbours that do not meet there are joined by a short edge across. reach_m: how far a node may
/// lie from those points.
///
/// The ring has three corners at least: of two edges the arcs are halved. False when an edge would run backwards or the
/// ring would cross itself.
bool join_edges(std::span<const EdgeShape> edges, double spacing_m, double reach_m, VectorRing& out);

}  // namespace jalon
