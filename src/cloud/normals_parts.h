// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "base/field.h"
#include "cloud/cloud.h"
#include "cloud/operations.h"
#include "spatial/octree/octree.h"

namespace jalon {

/// An empty "normal" column for this many points.
std::shared_ptr<Column> new_normal_column(size_t count);

/// Method 3 (Girardeau-Montaut 2006, A.2): the normal, at the point, of the quadric through the
/// neighbours; the least-squares plane's where they do not fix a quadric, NaN where they do not
/// span a plane. Caller's order.
std::shared_ptr<Column> quadric_normals(const Octree& tree, uint32_t k, double radius_m,
                                        Task& task);

/// Method 2: a 2D Delaunay triangulation of each octree cell's points; a vertex takes the sum of
/// its triangles' normals, which weighs them by area. Less robust to noise than the others, worst
/// at cell borders, and no faster: PCA costs less than a triangulation. Caller's order.
std::shared_ptr<Column> triangulation_normals(const Octree& tree, Task& task);

/// Checks the orientation against the cloud, before the long work: Error(kInvalidArgument)
/// when a point has no station pose, or the viewpoint is not three numbers.
void require_orientation(const Cloud& cloud, const NormalsSettings& settings);
/// Flips normals where needed; NaN stays. The orientation must have passed the check.
void orient(const Cloud& cloud, const NormalsSettings& settings, Column& normal, Task& task);

}  // namespace jalon
