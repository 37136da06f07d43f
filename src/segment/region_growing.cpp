// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <iterator>

#include "base/settings_json.h"
#include "segment/growing/growing.h"
#include "segment/segmentation.h"
#include "segment/settle/ending.h"
#include "segment/settle/merging.h"

namespace jalon {

namespace {

constexpr int kRounds = 2;  // the second finds what stands at the edges of the first one's surfaces

// Regions that did not become large enough with their coplanar neighbours; their points may go to others.
void drop_small(uint32_t min_points, double points_per_member, std::vector<Surface>& surfaces) {
  std::erase_if(surfaces, [&](const Surface& surface) {
    return static_cast<double>(surface.positions.size()) * points_per_member < min_points;
  });
}

}  // namespace

// Surface growing (Vosselman et al. 2004) from running sums:
// 1. normals from neighbours; 2. regions from the flattest seeds; 3. coplanar neighbours joined and points shared out;
// 4. steps 1-3 among the points left over; 5. last fit, orientation classes and facade frame.
Segmentation segment_region_growing(const CloudPtr& cloud, const GrowingSettings& settings,
                                    Task& task) {
  require_area(*cloud, task);
  SegmentScene scene = [&] {
    ProgressSpan span(task, 0, 0.1, "indexing");
    return indexed_scene(*cloud, settings.surface, task);
  }();
  if (settings.field_normals()) take_field_normals(scene, task);
  std::vector<Surface> surfaces;
  for (int round = 0; round < kRounds; ++round) {
    if (std::count(scene.owner.begin(), scene.owner.end(), 0u) < 3) break;
    const double from = 0.1 + 0.43 * round;
    GrowingPoints points = [&] {
      ProgressSpan span(task, from, from + 0.2, "normals");
      return points_to_grow(scene, settings, task);
    }();
    std::vector<Surface> grown = [&] {
      ProgressSpan span(task, from + 0.2, from + 0.35, "growing");
      return grow_surfaces(scene, points, static_cast<uint32_t>(surfaces.size() + 1), task);
    }();
    const double points_per_member = points.points_per_member;
    points = {};
    surfaces.insert(surfaces.end(), std::make_move_iterator(grown.begin()),
                    std::make_move_iterator(grown.end()));
    ProgressSpan span(task, from + 0.35, from + 0.43, "sharing out points");
    if (settings.surface.merge_gap_m > 0) merge_coplanar(scene, surfaces, task);
    drop_small(settings.surface.min_points, points_per_member, surfaces);
    share_out_points(scene, surfaces, task);
  }
  ProgressSpan span(task, 0.96, 1, "last fit");
  Segmentation out = finish_segmentation(cloud, scene, surfaces, task);
  out.parameters_json = settings_json(region_growing_rows(), settings);
  return out;
}

}  // namespace jalon
