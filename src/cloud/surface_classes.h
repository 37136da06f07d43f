// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>

#include "base/field.h"
#include "base/task.h"
#include "spatial/octree/octree.h"

namespace jalon {

/// What the neighbours of a point show (Belton & Lichti 2006).
enum class SurfaceClass : uint8_t {
  kUnknown = 0,   ///< the neighbours span no plane
  kSurface = 1,   ///< one surface on all sides
  kEdge = 2,      ///< one surface that ends here: borders of openings, silhouettes, shadows
  kBoundary = 3,  ///< two surfaces or more meet here
};

/// Field "surface_class" from the principal axes of each point's neighbours: the k nearest, or those within radius_m
/// where that is above 0.
std::shared_ptr<Column> surface_classes(const Octree& tree, uint32_t k, double radius_m,
                                        Task& task);

}  // namespace jalon
