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
#include "segment/triangles/grid_mesh.h"
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
    choice_row<&TriangleSettings::network>(
        "network", "local|grid", "triangle_growing",
        "What the triangles are: local Delaunay triangles of the points, or neighbours in the "
        "scanner's grid, by the fields row and column, which costs less; local where there are no "
        "such grids."),
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

bool takes(const SegmentScene& scene, const Plane& plane, size_t position) {
  return std::fabs(plane.distance(scene.local(position))) <= scene.settings.distance_tolerance_m;
}

// Each point of the mesh is its region's, where it lies in the plane.
void take_members(SegmentScene& scene, const GrowingPoints& points, const TriangleRegions& regions,
                  uint32_t first, Task& task) {
  parallel_for(task, regions.labels.size(), kTriangleCellsPerChunk, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      const uint32_t label = regions.labels[i], position = points.position(i);
      if (label != 0 && takes(scene, regions.planes[label - 1], position))
        scene.owner[position] = first + label - 1;
    }
  });
}

// And so are the other free points of its cell, for which it stands.
void take_cells(SegmentScene& scene, const Representatives& cells, const GrowingPoints& points,
                const TriangleRegions& regions, uint32_t first, Task& task) {
  std::vector<uint32_t> label_of(scene.size(), 0);
  for (size_t i = 0; i < points.tree->size(); ++i) label_of[points.position(i)] = regions.labels[i];
  parallel_for(task, cells.points.size(), kTriangleCellsPerChunk, [&](size_t begin, size_t end) {
    for (size_t c = begin; c < end; ++c) {
      const size_t from = cells.first[c];
      const size_t to = c + 1 == cells.first.size() ? scene.size() : cells.first[c + 1];
      const uint32_t label = label_of[cells.points[c]];
      for (size_t i = from; i < to; ++i)
        if (label != 0 && scene.owner[i] == 0 && takes(scene, regions.planes[label - 1], i))
          scene.owner[i] = first + label - 1;
    }
  });
}

// Regions of a mesh over points of which each stands for so many free ones.
TriangleRegions regions_of(const Octree& tree, LocalMesh mesh, double points_per_member,
                           const TriangleSettings& settings, Task& task) {
  const double least = kLeastRegionShare * settings.surface.min_points / points_per_member;
  const TriangleRule rule{settings.surface.distance_tolerance_m, settings.angle_rad,
                          static_cast<uint64_t>(std::max(3.0, least))};
  return grow_triangles(tree, std::move(mesh), rule, task);
}

// Normals are what the sharing out of points asks first: while the first triangles stand there are none.
void look_at_cells_once(SegmentScene& scene, Task& task) {
  if (scene.normals.empty()) look_at_cells(scene, task);
}

uint32_t own_by_local_triangles(SegmentScene& scene, const TriangleSettings& settings,
                                uint32_t first, Task& task) {
  Representatives cells = one_per_cell(scene, task);
  if (cells.free < 3) return 0;
  const GrowingPoints points = thinned_points(scene, cells, task);
  const bool thin = pays(cells);
  if (!thin) cells = {};
  LocalMesh mesh = [&] {
    ProgressSpan span(task, 0, 0.7, "triangulating");
    return local_mesh(*points.tree, {.k = settings.k, .search_m = settings.search_m}, task);
  }();
  ProgressSpan span(task, 0.7, 1, "growing over triangles");
  const TriangleRegions regions =
      regions_of(*points.tree, std::move(mesh), points.points_per_member, settings, task);
  look_at_cells_once(scene, task);
  if (thin) take_cells(scene, cells, points, regions, first, task);
  else take_members(scene, points, regions, first, task);
  return static_cast<uint32_t>(regions.planes.size());
}

uint32_t own_by_grid_triangles(SegmentScene& scene, const TriangleSettings& settings,
                               uint32_t first, Task& task) {
  const GrowingPoints points{.tree = scene.tree};
  LocalMesh mesh = [&] {
    ProgressSpan span(task, 0, 0.7, "triangulating");
    const auto grids = scan_grids(scene.cloud, *scene.tree, scene.owner, task);
    return grid_mesh(*scene.tree, grids, {.k = settings.k, .search_m = settings.search_m}, task);
  }();
  ProgressSpan span(task, 0.7, 1, "growing over triangles");
  const TriangleRegions regions = regions_of(*scene.tree, std::move(mesh), 1, settings, task);
  look_at_cells_once(scene, task);
  take_members(scene, points, regions, first, task);
  return static_cast<uint32_t>(regions.planes.size());
}

}  // namespace

std::span<const ParamRow> triangle_growing_rows() { return kTriangleRows; }

// Surface growing on a network of triangles:
// 1. one point of each cell of the tolerance, since noise turns smaller triangles anyhow; 2. local Delaunay triangles;
// or, in their place, the triangles that a scanner's grid has between neighbours;
// 3. regions grown over them; 4. their cells' points taken, coplanar pieces
// joined, points shared out; 5. the same among the points left over; 6. last fit.
Segmentation segment_triangle_growing(const CloudPtr& cloud, const TriangleSettings& settings,
                                      Task& task) {
  require_area(*cloud, task);
  SegmentScene scene = [&] {
    ProgressSpan span(task, 0, 0.2, "indexing");
    return indexed_scene(*cloud, settings.surface, task);
  }();
  scene.normals = {};  // anew when the first triangles are gone, which are the peak of memory
  scene.spacing = {};
  scene.rejections = {};  // of draws, which there are none of
  const bool by_grid = settings.network == TriangleNetwork::kGrid && is_organised(*cloud, task);
  std::vector<Surface> surfaces = [&] {
    ProgressSpan span(task, 0.2, 0.85, "triangulating");
    return surfaces_in_rounds(scene, kTriangleRounds, task, [&](uint32_t first) {
      return by_grid ? own_by_grid_triangles(scene, settings, first, task)
                     : own_by_local_triangles(scene, settings, first, task);
    });
  }();
  ProgressSpan span(task, 0.85, 1, "last fit");
  Segmentation out = finish_segmentation(cloud, scene, surfaces, task);
  out.parameters_json = settings_json(triangle_growing_rows(), settings);
  return out;
}

}  // namespace jalon
