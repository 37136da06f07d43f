// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "segment/ransac/extraction.h"

namespace jalon {

/// Gives every point to its likeliest surface, by distance, sigma and density, among those within the tolerance whose
/// raster reaches the point: once all planes are known, no surface keeps what it took from later ones (Boulaassal
/// 2010, 3.4.5: robbery by order). Updates positions and scene.owner; surfaces keep their order.
void assign_points(SegmentScene& scene, std::vector<Surface>& surfaces, Task& task);

/// Each surface k - 1 the points that scene.owner gives to k, ascending.
void take_positions(const SegmentScene& scene, std::vector<Surface>& surfaces, Task& task);

}  // namespace jalon
