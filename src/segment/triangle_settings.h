// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "segment/segmentation.h"
#include "segment/surface_settings.h"

namespace jalon {

/// What the triangles are: local Delaunay triangles of the points, or neighbours in the scanner's grid.
enum class TriangleNetwork { kLocal, kGrid };

/// The parameters of method "triangle_growing"; the rows stand in triangle_growing.cpp.
struct TriangleSettings {
  SurfaceSettings surface;
  TriangleNetwork network = TriangleNetwork::kLocal;
  double search_m = 0;          ///< longest edge of a triangle; 0 = three local spacings
  double angle_rad = 0.174533;  ///< between a triangle and its region's plane, beyond the noise
  uint32_t k = 16;              ///< neighbours that a point's triangles are made of
};

/// Parameter table of method "triangle_growing".
std::span<const ParamRow> triangle_growing_rows();
/// Planes grown over local triangles (see triangle_growing.cpp for the steps).
Segmentation segment_triangle_growing(const CloudPtr& cloud, const TriangleSettings& settings,
                                      Task& task);

}  // namespace jalon
