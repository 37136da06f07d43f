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

/// Joins coplanar pieces, leaves out what is too small, and shares the points out anew among all planes.
void settle_found(SegmentScene& scene, std::vector<Surface>& surfaces, Task& task);

/// find(first) marks the free points of the planes it finds in scene.owner with first, first + 1 ..., and tells how
/// many they are. Then these are settled, and the points left are looked at once more: with the points of the large
/// planes gone, those of narrow ones beside them are alone in their cells.
template <class Find>
std::vector<Surface> surfaces_in_rounds(SegmentScene& scene, int rounds, Task& task, Find&& find);

/// What the methods do with the planes they found: coplanar pieces joined, points shared out anew among all planes,
/// last fit. All but parameters_json. Surfaces without points are left out.
Segmentation settled_segmentation(const CloudPtr& cloud, SegmentScene& scene,
                                  std::vector<Surface>& surfaces, Task& task);

/// Marks the points of surface k - 1 with k, all others as free.
void own_points(SegmentScene& scene, const std::vector<Surface>& surfaces);

template <class Find>
std::vector<Surface> surfaces_in_rounds(SegmentScene& scene, int rounds, Task& task, Find&& find) {
  std::vector<Surface> surfaces;
  for (int round = 0; round < rounds; ++round) {
    const ProgressSpan span(task, static_cast<double>(round) / rounds,
                            static_cast<double>(round + 1) / rounds);
    const auto before = static_cast<uint32_t>(surfaces.size());
    uint32_t found = 0;
    {
      const ProgressSpan finding(task, 0, 0.6);
      found = find(before + 1);
      if (found == 0) break;
      surfaces = surfaces_of_owners(scene, before + found, task);
    }
    const ProgressSpan settling(task, 0.6, 1, "sharing out points");
    settle_found(scene, surfaces, task);
    own_points(scene, surfaces);
  }
  return surfaces;
}

}  // namespace jalon
