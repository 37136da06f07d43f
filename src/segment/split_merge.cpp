// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "base/parallel.h"
#include "base/setting_rows.h"
#include "base/settings_json.h"
#include "segment/cells/flat_cells.h"
#include "segment/plane_rows.h"
#include "segment/settle/ending.h"
#include "segment/settle/found_planes.h"
#include "segment/split_settings.h"

namespace jalon {

namespace {

constexpr double kTolerancesPerCell =
    2;  // of least_cell_m = 0: in smaller ones noise is as wide as the cell

constexpr int kSplitRounds =
    3;  // the later ones find what stands at the edges of the first one's planes

constexpr auto kSplitLeast = plane_least_rows("split_merge");
constexpr auto kSplitPixel = plane_pixel_rows("split_merge");
constexpr auto kSplitEnding = plane_ending_rows("split_merge");

constexpr auto kSplitRows = setting_rows(
    nested_rows<&SplitSettings::surface, kSplitLeast>(),
    number_row<&SplitSettings::angle_rad>(
        "angle_rad", 0.001, 1.5, "rad", "split_merge",
        "Largest angle between a cell's plane and that of the region it joins, beyond what the "
        "noise turns it by; 0.175 = 10 degrees."),
    number_row<&SplitSettings::least_cell_m>(
        "least_cell_m", 0, 1000, "m", "split_merge",
        "Edge of the smallest cells, which are not split; 0 = twice distance_tolerance_m."),
    nested_rows<&SplitSettings::surface, kSplitPixel>(),
    nested_rows<&SplitSettings::surface, kSplitEnding>());

std::vector<uint32_t> free_positions(const SegmentScene& scene) {
  std::vector<uint32_t> free;
  for (size_t i = 0; i < scene.size(); ++i)
    if (scene.owner[i] == 0) free.push_back(static_cast<uint32_t>(i));
  return free;
}

// One round among the free points; how many planes.
uint32_t own_cells(SegmentScene& scene, const SplitSettings& settings, uint32_t first, Task& task) {
  const double tolerance = settings.surface.distance_tolerance_m;
  const double least =
      settings.least_cell_m > 0 ? settings.least_cell_m : kTolerancesPerCell * tolerance;
  const std::vector<uint32_t> points = free_positions(scene);
  if (points.size() < 3) return 0;
  const CellPoints of{*scene.tree, points};
  const std::vector<FlatCell> cells =
      split_cells(of, {.tolerance_m = tolerance, .least_cell_m = least}, task);
  const auto touching = touching_cells(of, cells, task);
  std::vector<uint32_t> labels;
  std::vector<Plane> planes;
  const uint32_t count =
      merge_cells(cells, touching, {tolerance, settings.angle_rad}, labels, planes, task);
  parallel_for(task, cells.size(), 256, [&](size_t begin, size_t end) {
    for (size_t c = begin; c < end; ++c)
      for (size_t i = cells[c].first; i < cells[c].last; ++i)
        if (std::fabs(planes[labels[c] - 1].distance(of.local(i))) <= tolerance)
          scene.owner[points[i]] = first + labels[c] - 1;
  });
  return count;
}

}  // namespace

std::span<const ParamRow> split_merge_rows() { return kSplitRows; }

// Split and merge on an octree (Wang & Tseng 2004; Boulaassal 2010, 2.3.2.3):
// 1. cells split until their points lie in one plane; 2. touching cells merged where one plane fits; 3. coplanar pieces
// joined, points shared out; 4. the same among the points left over, without those of the planes; 5. last fit.
Segmentation segment_split_merge(const CloudPtr& cloud, const SplitSettings& settings, Task& task) {
  require_area(*cloud, task);
  SegmentScene scene = [&] {
    ProgressSpan span(task, 0, 0.3, "indexing");
    return scene_with_cells(*cloud, settings.surface, task);
  }();
  std::vector<Surface> surfaces = [&] {
    ProgressSpan span(task, 0.3, 0.85, "splitting and merging");
    return surfaces_in_rounds(scene, kSplitRounds, task, [&](uint32_t first) {
      return own_cells(scene, settings, first, task);
    });
  }();
  ProgressSpan span(task, 0.85, 1, "last fit");
  Segmentation out = finish_segmentation(cloud, scene, surfaces, task);
  out.parameters_json = settings_json(split_merge_rows(), settings);
  return out;
}

}  // namespace jalon
