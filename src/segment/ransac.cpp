// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "base/settings_json.h"
#include "segment/ransac/sequence.h"
#include "segment/segmentation.h"
#include "segment/settle/ending.h"
#include "segment/settle/merging.h"
#include "segment/surface/tolerance.h"

namespace jalon {

namespace {

// With orientation classes asked for, planes that turned out to be of another one once all points were shared out.
void drop_other_classes(RansacScene& scene, std::vector<Surface>& surfaces) {
  if (!scene.axes) return;
  const OrientationOrder& order = scene.order;
  const auto asked_for = [&](const Surface& surface) {
    if (!surface.is_plane()) return true;
    const Orientation own =
        scene.axes->classify(surface.plane.normal, scene.settings.orientation_tolerance_rad);
    const auto end = order.classes.begin() + order.count;
    return std::find(order.classes.begin(), end, own) != end;
  };
  for (const Surface& surface : surfaces)
    if (!asked_for(surface))
      for (const uint32_t position : surface.positions) scene.owner[position] = 0;
  std::erase_if(surfaces, [&](const Surface& surface) { return !asked_for(surface); });
}

// No surface that a cloud shows bends about an axis further from it than the cloud is wide.
double widest_m(const Cloud& cloud, Task& task) {
  const Box3 box = bounds(cloud, task);
  return norm(box.max - box.min);
}

}  // namespace

// 1. sequence of planes; 2. coplanar neighbours joined; 3. points shared out anew among all planes; 4. last fit; 5.
// normals, orientation classes and facade frame.
Segmentation segment_ransac(const CloudPtr& cloud, const RansacSettings& settings, Task& task) {
  const OrientationOrder order = orientation_order(settings.draw.orientation_order);
  require_area(*cloud, task);
  std::vector<Surface> surfaces;
  RansacSettings used = settings;  // the tolerance and the largest radius may come from the cloud
  if (used.surface.max_radius_m == 0 && used.surface.curved())
    used.surface.max_radius_m = std::max(widest_m(*cloud, task), used.surface.min_radius_m);
  RansacScene scene = [&] {
    ProgressSpan span(task, 0, 0.3, "indexing");
    RansacScene made{indexed_scene(*cloud, used.surface, task), settings.draw, order};
    const Tolerance tolerance = tolerance_of(*cloud, *made.tree, settings, task);
    used.surface.distance_tolerance_m = tolerance.distance_tolerance_m;
    used.tolerance.sigma_m = tolerance.sigma_m;
    made.settings = used.surface;
    look_at_cells(made, task);
    return made;
  }();
  {
    ProgressSpan span(task, 0.3, 0.85, "finding planes");
    surfaces = extract_sequence(scene, task);
  }
  {
    ProgressSpan span(task, 0.85, 0.95, "sharing out points");
    if (scene.settings.connectivity) merge_coplanar(scene, surfaces, task);
    Assignment assignment;
    share_out_points(scene, surfaces, assignment, task);
    if (scene.settings.connectivity && merge_layers(scene, surfaces, task))
      share_out_points(scene, surfaces, assignment, task);
    drop_other_classes(scene, surfaces);
  }
  ProgressSpan span(task, 0.95, 1, "last fit");
  Segmentation out = finish_segmentation(cloud, scene, surfaces, task);
  out.parameters_json = settings_json(ransac_rows(), used);
  return out;
}

}  // namespace jalon
