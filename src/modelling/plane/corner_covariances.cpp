// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/plane/corner_covariances.h"

#include <cmath>

#include "base/numbers.h"
#include "modelling/plane/vertex_covariance.h"

namespace jalon {

namespace {

Vec2 turned_by(const Vec2& d, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * d.u - s * d.v, s * d.u + c * d.v};
}

// Edge e of the ring as its first or last corner sees it: an arc by its tangent there.
CornerEdge edge_of(const VectorRing& ring, size_t e, bool at_end, bool by_chord) {
  const Vec2 chord = ring.corners[(e + 1) % ring.corners.size()] - ring.corners[e];
  const double length = norm(chord), sagitta = ring.edges[e].sagitta_m;
  CornerEdge out;
  out.direction = chord * (1 / length);
  out.length_m = length;
  out.sigma_m = ring.edges[e].sigma_m;
  if (sagitta != 0 && !by_chord) {
    // Half the arc's angle lies between chord and tangent; it begins to the right of the chord when it bulges there.
    const double half = 2 * std::atan(2 * sagitta / length);
    out.direction = turned_by(out.direction, at_end ? half : -half);
  }
  return out;
}

}  // namespace

void set_covariances(Model& model, const PlaneFrame& frame, const Face& plane,
                     const RingVertices& ring) {
  std::array<double, 9> unknown;
  unknown.fill(kNaN);
  model.vertex_covariances.resize(model.vertices.size(), unknown);
  const size_t n = ring.vertices.size();
  for (size_t i = 0; i < n; ++i) {
    std::array<double, 9>& out = model.vertex_covariances[ring.vertices[i]];
    if (std::isfinite(out[0])) continue;
    UncertainSurface surface =
        plane_at(plane.plane, plane.covariance, model.vertices[ring.vertices[i]]);
    surface.sigma_m = std::hypot(surface.sigma_m, ring.extra_sigma_m);
    const size_t last = (i + n - 1) % n;
    for (const bool by_chord : {false, true}) {
      const auto found =
          corner_covariance(frame, surface, edge_of(*ring.ring, last, true, by_chord),
                            edge_of(*ring.ring, i, false, by_chord));
      if (!found) continue;
      out = *found;
      break;
    }
  }
}

}  // namespace jalon
