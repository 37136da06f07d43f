// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/settle/ending.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/parallel.h"
#include "segment/ransac/curved_extraction.h"
#include "segment/result/facade.h"
#include "segment/result/point_columns.h"
#include "segment/settle/assignment.h"
#include "segment/settle/each_surface.h"
#include "segment/settle/global_planarity.h"
#include "segment/settle/planes_of_lines.h"
#include "segment/settle/splitting.h"
#include "segment/settle/surface_fit.h"
#include "segment/surface/primitive_fits.h"

namespace jalon {

namespace {

constexpr size_t kEndingPointsPerChunk = 1 << 15;
constexpr int kAssignmentRounds = 3;
constexpr int kFitRounds = 3;

// A plane that was looked for as one of an orientation class stays in it: the points are few that leave it.
void settle_within_class(const SegmentScene& scene, const Surface& surface,
                         std::span<const uint8_t> inner, Task& task, PlaneFit& fit) {
  PlaneFit settled = fit;
  if (!settle_surface(scene, surface, inner, task, settled)) return;
  const auto class_of = [&](const PlaneFit& f) {
    return scene.axes->classify(f.plane.normal, scene.settings.orientation_tolerance_rad);
  };
  if (!scene.axes || class_of(settled) == class_of(fit)) fit = settled;
}

void fit_plane_segment(const SegmentScene& scene, Surface& surface, Task& task, Segment& segment) {
  segment.area_m2 = surface.area_m2;
  const std::vector<uint8_t> inner = points_off_border(scene, surface, task);
  // The core depends on the plane: to a fixed point. That of many points hardly does.
  const int rounds = is_large(surface) ? 1 : kFitRounds;
  for (int round = 0; round < rounds; ++round) {
    if (!fit_core(scene, surface, inner, task, segment.fit))
      fail(Status::kInternal, "a segment lost its plane");
    const bool is_fixed = surface.plane.normal == segment.fit.plane.normal &&
                          surface.plane.offset == segment.fit.plane.offset &&
                          surface.sigma_m == segment.fit.sigma;
    surface.plane = segment.fit.plane;
    surface.sigma_m = segment.fit.sigma;
    if (is_fixed) break;
  }
  settle_within_class(scene, surface, inner, task, segment.fit);
  const auto extent_of = [&](size_t begin, size_t end) {
    FlatBox part;
    for (size_t i = begin; i < end; ++i) {
      if (i + kFetchedAhead < end) scene.fetch_exact(surface.positions[i + kFetchedAhead]);
      const Vec3 d = scene.exact(surface.positions[i]) - segment.fit.centroid;
      part.add({dot(d, segment.fit.axis_u), dot(d, segment.fit.axis_v)});
    }
    return part;
  };
  const FlatBox extent =
      parallel_reduce(task, surface.positions.size(), kEndingPointsPerChunk, FlatBox{}, extent_of);
  segment.length_u_m = extent.high.u - extent.low.u;
  segment.length_v_m = extent.high.v - extent.low.v;
}

// Rows of the surfaces, largest first, fits in the local frame.
std::vector<Segment> make_segments(const SegmentScene& scene, std::vector<Surface>& surfaces,
                                   Task& task) {
  std::stable_sort(surfaces.begin(), surfaces.end(), [](const Surface& a, const Surface& b) {
    return a.positions.size() > b.positions.size();
  });
  std::vector<Segment> segments(surfaces.size());
  for_each_surface(surfaces, task, [&](size_t s) {
    Segment& segment = segments[s];
    segment.label = static_cast<uint32_t>(s + 1);
    if (surfaces[s].is_plane()) fit_plane_segment(scene, surfaces[s], task, segment);
    else if (!fit_curved_core(scene, surfaces[s], true, task, segment) &&
             !fit_curved_core(scene, surfaces[s], false, task, segment))
      fail(Status::kInternal, "a segment lost its sphere or cylinder");
  });
  return segments;
}

std::shared_ptr<Column> label_points(const SegmentScene& scene,
                                     const std::vector<Surface>& surfaces, Task& task) {
  auto column = make_label_column(scene.size());
  const auto labels = column->values<uint32_t>();
  std::fill(labels.begin(), labels.end(), 0u);
  for_each_surface(surfaces, task, [&](size_t s) {
    const auto& positions = surfaces[s].positions;
    parallel_for(task, positions.size(), kEndingPointsPerChunk, [&](size_t begin, size_t end) {
      for (size_t i = begin; i < end; ++i)
        labels[scene.order[positions[i]]] = static_cast<uint32_t>(s + 1);
    });
  });
  return column;
}

}  // namespace

// Fewer than 3 points, all equal or on one line: nothing that a plane could be fitted to.
void require_area(const Cloud& cloud, Task& task) {
  if (cloud.size() < 3)
    fail(Status::kInsufficientData, "the cloud has %zu points; a plane needs 3", cloud.size());
  Moments zero;
  zero.reference = cloud.point(0);
  const Moments moments = parallel_reduce(task, cloud.size(), kEndingPointsPerChunk, zero,
                                          [&](size_t begin, size_t end) {
                                            Moments part = zero;
                                            for (size_t i = begin; i < end; ++i)
                                              part.add(cloud.point(i));
                                            return part;
                                          });
  PlaneFit fit;
  if (!fit_plane(moments, fit))
    fail(Status::kDegenerate, "all %zu points are equal or on one line", cloud.size());
}

void share_out_points(SegmentScene& scene, std::vector<Surface>& surfaces, Task& task) {
  Assignment assignment;
  share_out_points(scene, surfaces, assignment, task);
}

void share_out_points(SegmentScene& scene, std::vector<Surface>& surfaces, Assignment& assignment,
                      Task& task) {
  drop_planes_of_lines(scene, surfaces, task);
  if (!scene.settings.reassign) return;
  const auto settle = [&] {
    for (int round = 0; round < kAssignmentRounds; ++round) {
      assignment.next_round(scene, surfaces, task);
      if (!refit_surfaces(scene, surfaces, task) && round > 0) break;
    }
  };
  settle();
  if (!scene.settings.connectivity || !split_surfaces(scene, surfaces, task)) return;
  refit_surfaces(scene, surfaces, task);
  settle();
}

Segmentation finish_segmentation(const CloudPtr& cloud, SegmentScene& scene,
                                 std::vector<Surface>& surfaces, Task& task) {
  const SurfaceSettings& settings = scene.settings;
  if (settings.global_planarity) refine_global_planarity(scene, surfaces, task);
  Segmentation out;
  out.cloud = cloud;
  out.segments = make_segments(scene, surfaces, task);
  const auto label_column = label_points(scene, surfaces, task);
  const auto labels = label_column->values<uint32_t>();
  out.labels = label_column;
  std::vector<uint64_t> points;
  for (Surface& surface : surfaces) {
    points.push_back(surface.positions.size());
    surface.positions = {};
  }
  release_points(scene);  // what follows goes by label, and holds tables of its own
  const FacadeContext context{*cloud, scene.origin, settings.orientation_tolerance_rad,
                              settings.facade_frame, scene.axes ? &*scene.axes : nullptr};
  turn_normals(context, labels, out.segments, task);
  classify(context, out.segments);
  out.T_facade_world = facade_transform(context, out.segments);
  add_point_columns(out, scene.origin, task);
  for (size_t s = 0; s < out.segments.size(); ++s) {
    Segment& segment = out.segments[s];
    shift_origin(segment, scene.origin);
    segment.fit.n = segment.sphere.n = segment.cylinder.n = points[s];
  }
  return out;
}

}  // namespace jalon
