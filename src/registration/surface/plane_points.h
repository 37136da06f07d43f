// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "registration/surface/planes.h"

namespace jalon {

/// What a unit of a neighbour's height adds to the plane of a point.
struct PlaneShare {
  uint32_t position = 0;
  double height = 0;  ///< of the plane at the point
  Vec3 slope;         ///< of the plane, 1 / m
};
/// Of all points that the plane of a point goes through; empty where it has none. Before: k
/// neighbours made the planes; the same ones are found again. After: a share a point, in the order
/// of their distance.
std::vector<PlaneShare> plane_shares(const SurfacePlanes& planes, uint32_t position, uint32_t k);

}  // namespace jalon
