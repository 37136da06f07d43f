// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>

#include "base/field.h"
#include "base/task.h"
#include "spatial/octree/octree.h"

namespace jalon {

/// One item a point, in the CALLER's order. normal: float32 x 3, unit length, sign as found (not oriented); curvature:
/// float32, surface variation lambda_0 / (lambda_0 + lambda_1 + lambda_2), only when asked for. Both NaN where the
/// neighbours do not span a plane (fewer than 3 distinct ones, or all on a line).
struct PcaNormals {
  std::shared_ptr<Column> normal;     ///< field "normal"
  std::shared_ptr<Column> curvature;  ///< field "curvature", or null
};

/// Normals of the least-squares planes (total least squares: Hoppe et al. 1992; Girardeau-Montaut 2006, A.2 method 1)
/// through the k nearest points of each point, itself included. 1 <= k <= 256.
PcaNormals pca_normals(const Octree& tree, uint32_t k, bool with_curvature, Task& task);
/// The same with all points in the closed ball of this radius.
PcaNormals pca_normals_radius(const Octree& tree, double radius_m, bool with_curvature, Task& task);

}  // namespace jalon
