// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/edges/join/form_sides.h"

namespace jalon {

std::vector<MeasuredEdge> sides_of(const VectorRing& form) {
  std::vector<MeasuredEdge> out(form.edges.size());
  for (size_t i = 0; i < out.size(); ++i) {
    const Vec2 &a = form.corners[i], &b = form.corners[(i + 1) % out.size()];
    const VectorEdge& edge = form.edges[i];
    if (edge.sagitta_m != 0 || (a.u == b.u) == (a.v == b.v)) continue;
    out[i].shape = straight_shape(a, b);
    out[i].shape.sigma_m = edge.sigma_m;
    out[i].shape.source = edge.source;
  }
  return out;
}

VectorRing with_sides(const VectorRing& form, std::span<const MeasuredEdge> sides) {
  VectorRing out = form;
  const size_t n = sides.size();
  for (size_t i = 0; i < n; ++i) {
    const EdgeShape& side = sides[i].shape;
    if (!(side.length_m > 0)) continue;
    Vec2 &a = out.corners[i], &b = out.corners[(i + 1) % n];
    if (side.line.direction.u == 0) a.u = b.u = side.line.point.u;
    else a.v = b.v = side.line.point.v;
    out.edges[i].sigma_m = side.sigma_m;
    out.edges[i].source = side.source;
  }
  return signed_area(out) * signed_area(form) > 0 ? out : form;
}

}  // namespace jalon
