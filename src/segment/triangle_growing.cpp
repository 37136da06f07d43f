// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "base/parallel.h"
#include "base/setting_rows.h"
#include "base/settings_json.h"
#include "segment/growing/thinning.h"
#include "segment/plane_rows.h"
#include "segment/settle/ending.h"
#include "segment/settle/found_planes.h"
#include "segment/triangle_settings.h"
#include "segment/triangles/local_mesh.h"
#include "segment/triangles/triangle_growth.h"

namespace jalon {

namespace {

constexpr double kLeastRegionShare = 0.25;  // of the least segment: such pieces may be joined
constexpr int kTriangleRounds =
    2;  // the second finds what stands at the edges of the first one's planes
constexpr size_t kTriangleCellsPerChunk = 1 << 14;

constexpr auto kTriangleLeast = plane_least_rows("triangle_growing");
constexpr auto kTrianglePixel = plane_pixel_rows("triangle_growing");
constexpr auto kTriangleEnding = plane_ending_rows("triangle_growing");

constexpr auto kTriangleRows = setting_rows(
    nested_rows<&TriangleSettings::surface, kTriangleLeast>(),
    number_row<&TriangleSettings::search_m>(
        "search_m", 0, 100, "m", "triangle_growing",
        "Longest edge of a triangle: how far from a region its next points may lie; 0 = three "
        "times the local point spacing."),
    number_row<&TriangleSettings::angle_rad>(
        "angle_rad", 0.001, 1.5, "rad", "triangle_growing",
        "Largest angle between a triangle and its region's plane, beyond what the noise of its "
        "corners turns it by; 0.175 = 10 degrees."),
    integer_row<&TriangleSettings::k>("k", 6, 64, "points", "triangle_growing",
                                      "Nearest points that a point's triangles are made of."),
    nested_rows<&TriangleSettings::surface, kTrianglePixel>(),
    nested_rows<&TriangleSettings::surface, kTriangleEnding>());

// Every point of a cell is its representative's region's, where it lies in the plane.
void spread_labels(SegmentScene& scene, const Representatives& cells, const GrowingPoints& points,
                   const TriangleRegions& regions, uint32_t first, Task& task) {
  std::vector<uint32_t> label_of(scene.size(), 0);
  for (size_t i = 0; i < points.tree->size(); ++i) label_of[points.position(i)] = regions.labels[i];
  const double tolerance = scene.settings.distance_tolerance_m;
  parallel_for(task, cells.points.size(), kTriangleCellsPerChunk, [&](size_t begin, size_t end) {
    for (size_t c = begin; c < end; ++c) {
      const size_t from = cells.first[c];
      const size_t to = c + 1 == cells.first.size() ? scene.size() : cells.first[c + 1];
      const uint32_t common = pays(cells) ? label_of[cells.points[c]] : 0;
      for (size_t i = from; i < to; ++i) {
        if (scene.owner[i] != 0) continue;
        const uint32_t label = common != 0 ? common : label_of[i];
        if (label != 0 &&
            std::fabs(regions.planes[label - 1].distance(scene.local(i))) <= tolerance)
          scene.owner[i] = first + label - 1;
      }
    }
  });
}

TriangleRegions regions_of(const GrowingPoints& points, const TriangleSettings& settings,
                           Task& task) {
  const LocalMesh mesh = [&] {
    ProgressSpan span(task, 0, 0.7, "triangulating");
    return local_mesh(*points.tree, {.k = settings.k, .search_m = settings.search_m}, task);
  }();
  ProgressSpan span(task, 0.7, 1, "growing over triangles");
  const double least = kLeastRegionShare * settings.surface.min_points / points.points_per_member;
  const TriangleRule rule{settings.surface.distance_tolerance_m, settings.angle_rad,
                          static_cast<uint64_t>(std::max(3.0, least))};
  return grow_triangles(*points.tree, mesh, rule, task);
}

}  // namespace

std::span<const ParamRow> triangle_growing_rows() { return kTriangleRows; }

// Surface growing on a network of triangles:
// 1. one point of each cell of the tolerance, since noise turns smaller triangles anyhow; 2. local Delaunay triangles;
// 3. regions grown over them; 4. their cells' points taken, coplanar pieces
// joined, points shared out; 5. the same among the points left over; 6. last fit.
Segmentation segment_triangle_growing(const CloudPtr& cloud, const TriangleSettings& settings,
                                      Task& task) {
  require_area(*cloud, task);
  SegmentScene scene = [&] {
    ProgressSpan span(task, 0, 0.2, "indexing");
    return scene_with_cells(*cloud, settings.surface, task);
  }();
  std::vector<Surface> surfaces = [&] {
    ProgressSpan span(task, 0.2, 0.85, "triangulating");
    return surfaces_in_rounds(scene, kTriangleRounds, task, [&](uint32_t first) {
      const Representatives cells = one_per_cell(scene, task);
      if (cells.free < 3) return uint32_t{0};
      const GrowingPoints points = thinned_points(scene, cells, task);
      const TriangleRegions regions = regions_of(points, settings, task);
      spread_labels(scene, cells, points, regions, first, task);
      return static_cast<uint32_t>(regions.planes.size());
    });
  }();
  ProgressSpan span(task, 0.85, 1, "last fit");
  Segmentation out = finish_segmentation(cloud, scene, surfaces, task);
  out.parameters_json = settings_json(triangle_growing_rows(), settings);
  return out;
}

}  // namespace jalon
