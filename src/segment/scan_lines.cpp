// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "base/parallel.h"
#include "base/setting_rows.h"
#include "base/settings_json.h"
#include "segment/lines/line_growth.h"
#include "segment/plane_rows.h"
#include "segment/scan_line_settings.h"
#include "segment/settle/ending.h"
#include "segment/settle/found_planes.h"

namespace jalon {

namespace {

constexpr auto kScanLineLeast = plane_least_rows("scan_lines");
constexpr auto kScanLinePixel = plane_pixel_rows("scan_lines");
constexpr auto kScanLineEnding = plane_ending_rows("scan_lines");

constexpr auto kScanLineRows = setting_rows(
    nested_rows<&ScanLineSettings::surface, kScanLineLeast>(),
    number_row<&ScanLineSettings::line_tolerance_m>(
        "line_tolerance_m", 0, 10, "m", "scan_lines",
        "Largest distance of a row's points from its straight pieces; 0 = distance_tolerance_m."),
    number_row<&ScanLineSettings::gap_m>(
        "gap_m", 0, 100, "m", "scan_lines",
        "Gap at which a row breaks off; 0 = five times the median step between its points."),
    integer_row<&ScanLineSettings::line_points>("line_points", 3, 1000, "points", "scan_lines",
                                                "Fewest points of a straight piece."),
    nested_rows<&ScanLineSettings::surface, kScanLinePixel>(),
    nested_rows<&ScanLineSettings::surface, kScanLineEnding>());

std::vector<uint32_t> positions_of_points(const SegmentScene& scene, Task& task) {
  std::vector<uint32_t> positions(scene.size());
  parallel_for(task, scene.size(), 1 << 16, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) positions[scene.order[i]] = static_cast<uint32_t>(i);
  });
  return positions;
}

uint32_t own_lines(SegmentScene& scene, const std::vector<ScanPlace>& places,
                   const ScanLineSettings& settings, Task& task) {
  const double tolerance = settings.surface.distance_tolerance_m;
  const std::vector<uint32_t> positions = positions_of_points(scene, task);
  const std::vector<ScanLine> lines = straight_pieces(scene, places, positions, settings, task);
  const LineRegions regions = grow_lines(lines, lines_beside(lines, task), tolerance, task);
  for (size_t l = 0; l < lines.size(); ++l) {
    const uint32_t label = regions.labels[l];
    if (label == 0) continue;
    for (uint32_t i = lines[l].first; i < lines[l].last; ++i) {
      const uint32_t position = positions[places[i].point];
      if (std::fabs(regions.planes[label - 1].distance(scene.local(position))) <= tolerance)
        scene.owner[position] = label;
    }
  }
  return static_cast<uint32_t>(regions.planes.size());
}

}  // namespace

std::span<const ParamRow> scan_line_rows() { return kScanLineRows; }

// Scan-line grouping (Jiang & Bunke 1994; Boulaassal 2010, 2.3.2.2):
// 1. points row by row as the scanner took them; 2. each row cut into straight pieces; 3. pieces grown to planes across
// rows; 4. coplanar pieces joined, points shared out among all planes, last fit.
Segmentation segment_by_scan_lines(const CloudPtr& cloud, const ScanLineSettings& settings,
                                   Task& task) {
  require_area(*cloud, task);
  const std::vector<ScanPlace> places = [&] {
    ProgressSpan span(task, 0, 0.1, "ordering rows");
    return scan_places(*cloud, task);
  }();
  SegmentScene scene = [&] {
    ProgressSpan span(task, 0.1, 0.4, "indexing");
    return scene_with_cells(*cloud, settings.surface, task);
  }();
  std::vector<Surface> surfaces = [&] {
    ProgressSpan span(task, 0.4, 0.7, "growing lines");
    const uint32_t count = own_lines(scene, places, settings, task);
    return surfaces_of_owners(scene, count, task);
  }();
  ProgressSpan span(task, 0.7, 1, "sharing out points");
  Segmentation out = settled_segmentation(cloud, scene, surfaces, task);
  out.parameters_json = settings_json(scan_line_rows(), settings);
  return out;
}

}  // namespace jalon
