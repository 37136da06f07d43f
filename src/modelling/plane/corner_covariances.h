// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "model/model.h"
#include "modelling/plane/vector_plane.h"

namespace jalon {

/// A ring of a plane and the vertices of its corners, in the plane or parallel to it.
struct RingVertices {
  const VectorRing* ring = nullptr;
  std::vector<uint32_t> vertices;
  double extra_sigma_m = 0;  ///< across the plane, of vertices parallel to it: that of their depth
};

/// Sets the covariances of the ring's vertices from the positions of the two edges that meet in
/// each (VectorEdge::sigma_m) and the plane's own covariance (vertex_covariance.h). At the end of
/// an arc that runs on from its neighbour without a corner the arc's chord counts as its direction.
///
/// Before: plane has its covariance; ring.vertices, one a corner, are in the model. After:
/// model.vertex_covariances is as long as its vertices, NaN where an edge has no sigma; what was
/// known already stays.
void set_covariances(Model& model, const PlaneFrame& frame, const Face& plane,
                     const RingVertices& ring);

}  // namespace jalon
