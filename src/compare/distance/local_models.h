// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

#include "base/task.h"
#include "cloud/cloud.h"
#include "compare/distance/distance_columns.h"
#include "compare/distance/settings.h"
#include "spatial/octree/octree.h"

namespace jalon {

/// Replaces distances to the nearest reference point by those to a surface through the reference
/// points around it (Girardeau-Montaut 2006, 2.3.2), where these are less: an odd surface must not
/// be worse than the point.
///
/// The surface belongs to the reference point (or, by the setting neighbourhood, to the
/// compared one), so the order of the points does not matter. It is made from coordinates on
/// the reference's grid (error below the cube's edge / 2^31). Plain distances stay where there
/// are fewer than three neighbours or all lie on a line, and where the foot on the surface is
/// farther from the nearest point than the neighbours reach, so that no surface is continued
/// into the void. A quadric that the neighbours do not fix gives way to the plane.
///
/// nearest: for each sorted position of compared the sorted position of its nearest reference
/// point, or kNoPoint. Returns how many distances are those to a surface.
uint64_t apply_local_models(const Octree& reference, const Octree& compared,
                            const Cloud& compared_cloud, std::span<const uint32_t> nearest,
                            const DistanceSettings& settings, const DistanceColumns& columns,
                            Task& task);

}  // namespace jalon
