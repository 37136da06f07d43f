// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "segment/ransac/hypotheses.h"

namespace jalon {

/// Draw number `draw` of a sphere or a cylinder (steps in curved_hypotheses.cpp); false when it gives none that its
/// surroundings support, as always where no point is free.
bool draw_curved(const RansacScene& scene, const PointPool& pool, uint64_t draw, Task& task,
                 Candidate& out);

/// The inlier test of a curved surface; a cell's normal turns by edge / (2 r) from its middle to its side, which the
/// test allows for.
CurvedTest curved_test(const SegmentScene& scene, const Curved& curved, double cell_edge_m,
                       double tolerance_m);

/// True when the normal of the point disagrees with the surface's.
bool curved_inconsistent(const SegmentScene& scene, const Curved& curved, size_t position);

}  // namespace jalon
