// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "segment/ransac/extraction.h"

namespace jalon {

/// Plane and sigma of each surface from its points; area from its raster. Surfaces that fall below the minimum are
/// dropped, their points set free; returns true when one was.
bool refit_surfaces(SegmentScene& scene, std::vector<Surface>& surfaces, Task& task);

/// Least squares on a surface's core points, from the caller's doubles.
bool fit_core(const SegmentScene& scene, const Surface& surface, Task& task, PlaneFit& fit);
/// The last word on a surface's plane: points of other surfaces that meet it are told from its own, and the covariance
/// allows for them (see geometry/contaminated_plane.h). fit: that of fit_core, whose sigma and number of points stay.
/// False, and fit as it was, where nothing is to be told apart.
bool settle_surface(const SegmentScene& scene, const Surface& surface, Task& task, PlaneFit& fit);

}  // namespace jalon
