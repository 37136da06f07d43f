// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "segment/growing/points.h"
#include "segment/ransac/extraction.h"

namespace jalon {

/// Surfaces grown one after the other from the flattest places (seeds by planarity: Vosselman et al. 2004), leaf by
/// leaf: a point joins when it is within the tolerance of the running plane and its normal within the angle of the
/// plane's (Stamos & Allen 2002); the plane is refitted as the region grows, from
/// running sums. Their points are marked in scene.owner with first_id, first_id + 1 ...
std::vector<Surface> grow_surfaces(SegmentScene& scene, const GrowingPoints& points,
                                   uint32_t first_id, Task& task);

}  // namespace jalon
