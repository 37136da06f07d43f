// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/ending.h"
#include "segment/merging.h"
#include "segment/segmentation.h"
#include "segment/sequence.h"

namespace jalon {

// 1. sequence of planes; 2. coplanar neighbours joined; 3. points shared out anew among all planes; 4. last fit; 5.
// normals, orientation classes and facade frame.
Segmentation segment_ransac(const CloudPtr& cloud, const ParamSet& params, Task& task) {
  const RansacSettings settings = ransac_settings(params);
  require_area(*cloud, task);
  std::vector<Surface> surfaces;
  SegmentScene scene = [&] {
    Span span(task, 0, 0.3, "indexing");
    return make_scene(*cloud, settings, task);
  }();
  {
    Span span(task, 0.3, 0.85, "finding planes");
    surfaces = extract_sequence(scene, task);
  }
  {
    Span span(task, 0.85, 0.95, "sharing out points");
    if (settings.connectivity) merge_coplanar(scene, surfaces, task);
    share_out_points(scene, surfaces, task);
  }
  Span span(task, 0.95, 1, "last fit");
  return finish_segmentation(cloud, scene, surfaces, params, task);
}

}  // namespace jalon
