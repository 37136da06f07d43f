// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <iterator>

#include "segment/ending.h"
#include "segment/growing.h"
#include "segment/merging.h"
#include "segment/segmentation.h"

namespace jalon {

namespace {

constexpr int kRounds = 2;  // the second finds what stands at the edges of the first one's surfaces

// Regions that did not become large enough with their coplanar neighbours; their points may go to others.
void drop_small(SegmentScene& scene, std::vector<Surface>& surfaces) {
  std::erase_if(surfaces, [&](const Surface& surface) {
    const bool small = surface.positions.size() < scene.settings.min_points;
    for (const uint32_t position : surface.positions)
      if (small) scene.owner[position] = 0;
    return small;
  });
}

}  // namespace

// Surface growing with the steps of plane-extraction from running sums:
// 1. normals from neighbours; 2. regions from the flattest seeds; 3. coplanar neighbours joined and points shared out;
// 4. steps 1-3 among the points left over; 5. last fit, orientation classes and facade frame.
Segmentation segment_region_growing(const CloudPtr& cloud, const ParamSet& params, Task& task) {
  const GrowingSettings settings = growing_settings(params);
  require_area(*cloud, task);
  SegmentScene scene = [&] {
    Span span(task, 0, 0.1, "indexing");
    return indexed_scene(*cloud, settings.planes, task);
  }();
  if (settings.field_normals) take_field_normals(scene, task);
  std::vector<Surface> surfaces;
  for (int round = 0; round < kRounds; ++round) {
    if (std::count(scene.owner.begin(), scene.owner.end(), 0u) < 3) break;
    const double from = 0.1 + 0.45 * round;
    GrowingPoints points = [&] {
      Span span(task, from, from + 0.2, "normals");
      return points_to_grow(scene, settings, task);
    }();
    std::vector<Surface> grown = [&] {
      Span span(task, from + 0.2, from + 0.35, "growing");
      return grow_surfaces(scene, points, static_cast<uint32_t>(surfaces.size() + 1), task);
    }();
    points = {};
    surfaces.insert(surfaces.end(), std::make_move_iterator(grown.begin()), std::make_move_iterator(grown.end()));
    Span span(task, from + 0.35, from + 0.45, "sharing out points");
    if (settings.planes.merge_gap_m > 0) merge_coplanar(scene, surfaces, task);
    drop_small(scene, surfaces);
    share_out_points(scene, surfaces, task);
  }
  return finish_segmentation(cloud, scene, surfaces, params, task);
}

}  // namespace jalon
