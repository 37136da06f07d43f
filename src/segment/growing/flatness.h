// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/plane.h"
#include "segment/growing/points.h"

namespace jalon {

/// Plane through the free points of a leaf and of those near it; false when they are too few, too thick or too narrow
/// to begin a surface with.
bool seed_plane(const SegmentScene& scene, const GrowingPoints& points, size_t leaf, PlaneFit& fit);

/// The leaves that can begin a surface, by planarity: least sigma first, ties by their order on the curve.
std::vector<uint32_t> seeds_by_flatness(const SegmentScene& scene, const GrowingPoints& points,
                                        Task& task);

/// True when the surface turns by more than 20 degrees from end to end: a piece of a column or a sphere whose noise
/// hides in the tolerance. From the quadric through an even sample of the members.
bool is_bent(const PlaneFit& fit, const GrowingPoints& points,
             const std::vector<uint32_t>& members);

}  // namespace jalon
