// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "segment/ransac/extraction.h"

namespace jalon {

/// extract_surface for a candidate that is a sphere or a cylinder; connectivity on its map (surface_map.h).
bool extract_curved(SegmentScene& scene, PointPool& pool, const Candidate& candidate,
                    uint32_t owner_id, Task& task, Surface& out);

/// Least squares on the surface's points within its core, from the caller's doubles; robust: with weights that leave
/// outliers out and a covariance that is honest all the same. Area and extents from all its points.
bool fit_curved_core(const SegmentScene& scene, const Surface& surface, bool robust, Task& task,
                     Segment& out);

/// The surface's shape, sigma and area anew from its points; false when it is too small, too rough, or bends so little
/// that it might as well be a plane.
bool refit_curved(const SegmentScene& scene, Surface& surface, Task& task);

}  // namespace jalon
