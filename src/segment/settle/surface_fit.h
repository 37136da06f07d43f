// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "segment/ransac/extraction.h"

namespace jalon {

/// A surface of so many points that a part of them tells its plane well enough while points are shared out.
bool is_large(const Surface& surface);

/// Plane and sigma of each surface from its points, or from a part of many; area from its raster. Surfaces that fall
/// below the minimum are dropped, their points set free; returns true when one was.
bool refit_surfaces(SegmentScene& scene, std::vector<Surface>& surfaces, Task& task);

/// For each point of the surface whether it lies away from its border; empty where its fit does not ask.
std::vector<uint8_t> points_off_border(const SegmentScene& scene, const Surface& surface,
                                       Task& task);

/// Least squares on a surface's core points, from the caller's doubles.
bool fit_core(const SegmentScene& scene, const Surface& surface, Task& task, PlaneFit& fit);
/// The same with points_off_border() at hand.
bool fit_core(const SegmentScene& scene, const Surface& surface, std::span<const uint8_t> inner,
              Task& task, PlaneFit& fit);
/// The last word on a surface's plane: points of other surfaces that meet it are told from its own, and the covariance
/// allows for them (see geometry/contaminated_plane.h). inner: points_off_border(). fit: that of fit_core, whose sigma
/// and number of points stay. False, and fit as it was, where nothing is to be told apart.
bool settle_surface(const SegmentScene& scene, const Surface& surface,
                    std::span<const uint8_t> inner, Task& task, PlaneFit& fit);

}  // namespace jalon
