// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "segment/ransac/extraction.h"
#include "segment/segmentation.h"

namespace jalon {

/// Surfaces 1 ... count from the points that scene.owner gives them: plane and sigma by least squares, area by raster.
/// The list keeps its length; what is too small for a quarter of a segment, too narrow or too rough for a plane has
/// no points, and its points are free again. Spacing must be known.
std::vector<Surface> surfaces_of_owners(SegmentScene& scene, uint32_t count, Task& task);

/// What the methods do with the planes they found: coplanar pieces joined, points shared out anew among all planes,
/// last fit. All but parameters_json. Surfaces without points are left out.
Segmentation settled_segmentation(const CloudPtr& cloud, SegmentScene& scene,
                                  std::vector<Surface>& surfaces, Task& task);

}  // namespace jalon
