// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "modelling/plane/vector_plane.h"
#include "unit/modelling/plane_rings.h"

namespace upright_planes {

using namespace jalon;

inline constexpr double kSpacing_m = 0.05;

using rings::ring_of;
inline VectorRing rectangle(double u0, double u1, double v0, double v1) {
  return ring_of({{u0, v0}, {u1, v0}, {u1, v1}, {u0, v1}});
}

/// A plane at this height over y = 0 that looks along -Y; u is x, v is z.
inline VectorPlane plane_of(std::vector<VectorRing> outlines, double height_m = 0) {
  VectorPlane plane;
  plane.frame = {{0, 0, 0}, {1, 0, 0}, {0, 0, 1}, {0, -1, 0}, height_m};
  plane.spacing_m = kSpacing_m;
  for (VectorRing& ring : outlines) plane.faces.push_back({std::move(ring), {}});
  return plane;
}

}  // namespace upright_planes
