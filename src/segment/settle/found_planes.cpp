// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/settle/found_planes.h"

#include <algorithm>

#include "base/parallel.h"
#include "segment/settle/assignment.h"
#include "segment/settle/each_surface.h"
#include "segment/settle/ending.h"
#include "segment/settle/merging.h"
#include "segment/settle/positions.h"

namespace jalon {

namespace {

constexpr double kLeastPiece =
    0.25;  // of the least surface: pieces this large may be joined to their neighbours (as in growing.cpp)
constexpr size_t kFoundPointsPerChunk = 1 << 14;

// Plane, sigma, pixel and area of a surface from its points; false when it is none.
bool describe(const SegmentScene& scene, Surface& surface, Task& task) {
  const SurfaceSettings& settings = scene.settings;
  const size_t n = surface.positions.size();
  if (static_cast<double>(n) < std::max(3.0, kLeastPiece * settings.min_points)) return false;
  Moments zero;
  zero.reference = scene.local(surface.positions[0]);
  const Moments moments =
      parallel_reduce(task, n, kFoundPointsPerChunk, zero, [&](size_t begin, size_t end) {
        Moments part = zero;
        for (size_t i = begin; i < end; ++i) part.add(scene.local(surface.positions[i]));
        return part;
      });
  PlaneFit fit;
  if (!fit_plane(moments, fit) || !wide_enough(settings, fit) || too_rough(settings, fit.sigma))
    return false;
  surface.plane = fit.plane;
  surface.sigma_m = fit.sigma;
  surface.pixel_m = connectivity_pixel(
      settings, n, [&](size_t i) { return scene.spacing[surface.positions[i]]; }, task);
  const FlatFrame frame = plane_frame(surface.plane, scene.local(surface.positions[0]));
  const auto at = [&](size_t i) { return frame(scene.local(surface.positions[i])); };
  surface.area_m2 = occupied_area_m2(bounded_raster_of(n, at, surface.pixel_m, 0, task));
  return surface.area_m2 >= kLeastPiece * settings.min_area_m2;
}

void drop_small_planes(const SurfaceSettings& settings, std::vector<Surface>& surfaces) {
  std::erase_if(surfaces, [&](const Surface& surface) {
    return surface.positions.size() < std::max<size_t>(3, settings.min_points) ||
           surface.area_m2 < settings.min_area_m2;
  });
}

}  // namespace

std::vector<Surface> surfaces_of_owners(SegmentScene& scene, uint32_t count, Task& task) {
  std::vector<Surface> surfaces(count);
  take_positions(scene, surfaces, task);
  for_each_surface(surfaces, task, [&](size_t s) {
    if (describe(scene, surfaces[s], task)) return;
    for (const uint32_t position : surfaces[s].positions) scene.owner[position] = 0;
    surfaces[s].positions = {};
  });
  return surfaces;
}

void settle_found(SegmentScene& scene, std::vector<Surface>& surfaces, Task& task) {
  std::erase_if(surfaces, [](const Surface& s) { return s.positions.empty(); });
  if (scene.settings.merge_gap_m > 0) merge_coplanar(scene, surfaces, task);
  drop_small_planes(scene.settings, surfaces);
  Assignment assignment;
  share_out_points(scene, surfaces, assignment, task);
  if (merge_layers(scene, surfaces, task)) share_out_points(scene, surfaces, assignment, task);
}

void own_points(SegmentScene& scene, const std::vector<Surface>& surfaces) {
  std::fill(scene.owner.begin(), scene.owner.end(), 0u);
  for (size_t s = 0; s < surfaces.size(); ++s)
    for (const uint32_t position : surfaces[s].positions)
      scene.owner[position] = static_cast<uint32_t>(s + 1);
}

Segmentation settled_segmentation(const CloudPtr& cloud, SegmentScene& scene,
                                  std::vector<Surface>& surfaces, Task& task) {
  {
    ProgressSpan span(task, 0, 0.6, "sharing out points");
    settle_found(scene, surfaces, task);
  }
  ProgressSpan span(task, 0.6, 1, "last fit");
  return finish_segmentation(cloud, scene, surfaces, task);
}

}  // namespace jalon
