// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/plane/vector_plane.h"

#include <cmath>

#include "geometry/polygon2.h"
#include "model/topology.h"

namespace jalon {

double signed_area(const VectorRing& ring) {
  double area = signed_area(std::span<const Vec2>(ring.corners));
  for (size_t i = 0; i < ring.edges.size(); ++i) {
    const double s = ring.edges[i].sagitta_m;
    if (s == 0) continue;
    // Circular segment between arc and chord: r^2 (angle - sin angle) / 2, outside the chord for a positive sagitta.
    const Arc2 arc = arc_of(ring.corners[i], ring.corners[(i + 1) % ring.corners.size()], s);
    const double angle = 4 * std::atan(std::fabs(arc.bulge));
    area += std::copysign(arc.radius * arc.radius * (angle - std::sin(angle)) / 2, s);
  }
  return area;
}

double area(const VectorFace& face) {
  double sum = signed_area(face.outline);
  for (const VectorRing& opening : face.openings)
    sum += signed_area(opening);  // clockwise: negative
  return sum;
}

std::vector<Vec2> flattened(const VectorRing& ring, double chord_error_m) {
  std::vector<Vec2> out;
  out.reserve(ring.corners.size());
  for (size_t i = 0; i < ring.corners.size(); ++i)
    append_arc(out, ring.corners[i], ring.corners[(i + 1) % ring.corners.size()],
               ring.edges[i].sagitta_m, chord_error_m);
  return out;
}

}  // namespace jalon
