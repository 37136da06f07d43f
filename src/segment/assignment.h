// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "segment/extraction.h"

namespace jalon {

/// Gives every point to its likeliest surface, by distance, sigma and density, among those within the tolerance whose
/// raster reaches the point: once all planes are known, no surface keeps what it took from later ones (Boulaassal
/// 2010, 3.4.5: robbery by order). Updates positions and scene.owner; surfaces keep their order.
void assign_points(SegmentScene& scene, std::vector<Surface>& surfaces, Task& task);

/// Plane and sigma of each surface from its points; area from its raster. Surfaces that fall below the minimum are
/// dropped, their points set free; returns true when one was.
bool refit_surfaces(SegmentScene& scene, std::vector<Surface>& surfaces, Task& task);

/// Least squares on a surface's core points, from the caller's doubles.
bool fit_core(const SegmentScene& scene, const Surface& surface, Task& task, PlaneFit& fit);

}  // namespace jalon
