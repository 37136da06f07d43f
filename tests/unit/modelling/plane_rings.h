// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "modelling/plane/vector_plane.h"

// Rings and planes made by hand, for tests of what is done with them.
namespace rings {

using namespace jalon;

inline VectorRing ring_of(std::vector<Vec2> corners) {
  const size_t n = corners.size();
  return VectorRing{std::move(corners), std::vector<VectorEdge>(n), {}};
}

/// Anticlockwise, from its lower left corner.
inline VectorRing rectangle(const Vec2& low, const Vec2& high) {
  return ring_of({low, {high.u, low.v}, high, {low.u, high.v}});
}

/// Clockwise, from its lower left corner.
inline VectorRing hole(const Vec2& low, const Vec2& high) {
  return ring_of({low, {low.u, high.v}, high, {high.u, low.v}});
}

/// A plane that faces -y at y = -height, seen from the street: u = x, v = z.
inline PlaneFrame street_frame(double height = 0) {
  return {{}, {1, 0, 0}, {0, 0, 1}, {0, -1, 0}, height};
}

inline VectorPlane wall_of(std::vector<VectorFace> faces, double spacing_m, double height = 0) {
  VectorPlane out;
  out.label = 1;
  out.frame = street_frame(height);
  out.spacing_m = spacing_m;
  out.max_edge_m = 4 * spacing_m;
  out.faces = std::move(faces);
  return out;
}

}  // namespace rings
