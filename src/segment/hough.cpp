// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "base/setting_rows.h"
#include "base/settings_json.h"
#include "segment/hough/peaks.h"
#include "segment/hough_settings.h"
#include "segment/plane_rows.h"
#include "segment/settle/ending.h"
#include "segment/settle/found_planes.h"

namespace jalon {

namespace {

constexpr auto kHoughLeast = plane_least_rows("hough");
constexpr auto kHoughPixel = setting_rows(
    number_row<&SurfaceSettings::pixel_m>("pixel_m", 0, 100, "m", "hough",
                                          "Edge of a raster pixel for connectivity, area and "
                                          "re-assignment; 0 = twice the point spacing of the "
                                          "segment."),
    number_row<&SurfaceSettings::gap_m>("gap_m", 0, 1000, "m", "hough",
                                        "Widest gap within a surface."));
constexpr auto kHoughEnding = plane_ending_rows("hough");

constexpr auto kHoughRows = setting_rows(
    nested_rows<&HoughSettings::surface, kHoughLeast>(),
    number_row<&HoughSettings::angle_step_rad>(
        "angle_step_rad", 0.01, 0.5, "rad", "hough",
        "Step of the accumulator's two angles; 0.0436 = 2.5 degrees."),
    number_row<&HoughSettings::distance_step_m>(
        "distance_step_m", 0, 10, "m", "hough",
        "Step of the accumulator's distance; 0 = twice distance_tolerance_m."),
    choice_row<&HoughSettings::votes>(
        "votes", "normals|all", "hough",
        "Planes that a point votes for: those within 10 degrees of its normal, or all that go "
        "through it, as the transform is written."),
    integer_row<&HoughSettings::voters>("voters", 100, 1e7, "points", "hough",
                                        "Points that vote in a round, taken evenly."),
    nested_rows<&HoughSettings::surface, kHoughPixel>(),
    nested_rows<&HoughSettings::surface, kHoughEnding>());

}  // namespace

std::span<const ParamRow> hough_rows() { return kHoughRows; }

// The Hough transform for planes (Hough 1962; Vosselman et al. 2004; Boulaassal 2010, 2.3.3.1):
// 1. points vote for the planes through them; 2. each peak's plane is adjusted and followed over all points; 3. the
// points left vote anew; 4. coplanar pieces joined, points shared out, last fit.
Segmentation segment_hough(const CloudPtr& cloud, const HoughSettings& settings, Task& task) {
  require_area(*cloud, task);
  RansacScene scene = [&] {
    ProgressSpan span(task, 0, 0.3, "indexing");
    return RansacScene{scene_with_cells(*cloud, settings.surface, task), {}, {}};
  }();
  std::vector<Surface> surfaces = [&] {
    ProgressSpan span(task, 0.3, 0.7, "counting votes");
    return surfaces_of_peaks(scene, settings, task);
  }();
  ProgressSpan span(task, 0.7, 1, "sharing out points");
  Segmentation out = settled_segmentation(cloud, scene, surfaces, task);
  out.parameters_json = settings_json(hough_rows(), settings);
  return out;
}

}  // namespace jalon
