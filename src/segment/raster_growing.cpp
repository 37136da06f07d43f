// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/setting_rows.h"
#include "base/settings_json.h"
#include "segment/plane_rows.h"
#include "segment/raster/directions.h"
#include "segment/raster/search.h"
#include "segment/raster_settings.h"
#include "segment/settle/assignment.h"
#include "segment/settle/ending.h"
#include "segment/settle/found_planes.h"

namespace jalon {

namespace {

constexpr size_t kLeastForLarge =
    1 << 18;  // points: the rasters of fewer take some hundredths of a second
constexpr uint32_t kMostCoarseEdges = 4;   // a sixteenth of the points
constexpr double kCoarsePixelsPerGap = 2;  // of merge_gap_m
constexpr uint64_t kLeastCoarsePixels =
    256;  // of a large plane: 16 x 16, whose border is a quarter of it

constexpr auto kRasterLeast = plane_least_rows("raster_growing");
constexpr auto kRasterPixel = setting_rows(number_row<&SurfaceSettings::pixel_m>(
    "pixel_m", 0, 100, "m", "raster_growing",
    "Edge of a raster pixel, also for area and re-assignment; 0 = 1.4 times the point spacing."));
constexpr auto kRasterEnding = plane_ending_rows("raster_growing");

// Origins: the comparison of 2006 (3 x 3 pixels, nearest return); layers and directions by trial on the scenes
// of the unit tests.
constexpr auto kRasterRows = setting_rows(
    nested_rows<&RasterSettings::surface, kRasterLeast>(),
    choice_row<&RasterSettings::projection>(
        "projection", "directions|main|given", "raster_growing",
        "Planes that the points are projected on: one for each dominant direction of the surfaces, "
        "one for the most frequent, which loses what stands upright on it, or the given one."),
    doubles_row<&RasterSettings::direction>(
        "direction", -1, 1, "1", "raster_growing",
        "Normal of the plane of projection = given, toward the viewer: x, y, z."),
    integer_row<&RasterSettings::max_directions>("max_directions", 1, 64, "1", "raster_growing",
                                                 "Most directions with a raster."),
    integer_row<&RasterSettings::layers>(
        "layers", 1, 64, "1", "raster_growing",
        "Most rasters of one direction: each shows the points that those before it left, as what "
        "lies behind a front."),
    nested_rows<&RasterSettings::surface, kRasterPixel>(),
    choice_row<&RasterSettings::returns>(
        "returns", "nearest|median", "raster_growing",
        "Which of the points that share a pixel stands for it: the nearest to the viewer, or the "
        "middle one."),
    integer_row<&RasterSettings::seed_pixels>(
        "seed_pixels", 3, 31, "pixels", "raster_growing",
        "Edge of the window that a plane grows from; an even number counts as the next one."),
    number_row<&RasterSettings::gap_m>(
        "gap_m", 0, 100, "m", "raster_growing",
        "Widest row of empty pixels that growth crosses; 0 = two pixels."),
    integer_row<&RasterSettings::grey_bits>(
        "grey_bits", 0, 16, "bits", "raster_growing",
        "Grey values as an image file of so many bits has them; 0 = depths as they are."),
    nested_rows<&RasterSettings::surface, kRasterEnding>());

Vec3 given_direction(const RasterSettings& settings) {
  const std::vector<double>& d = settings.direction;
  const Vec3 n = d.size() == 3 ? normalized({d[0], d[1], d[2]}) : Vec3{};
  if (!(squared_norm(n) > 0.5))
    fail(Status::kInvalidArgument, "direction must be three numbers x, y, z, not all 0");
  return n;
}

// The planes of projection, each turned toward the stations where these are known.
std::vector<ImageAxes> planes_of_projection(const SegmentScene& scene,
                                            const RasterSettings& settings, Task& task) {
  std::vector<Vec3> normals;
  if (settings.projection == RasterProjection::kGiven) normals = {given_direction(settings)};
  else
    normals = dominant_directions(
        scene, settings.projection == RasterProjection::kMain ? 1 : settings.max_directions, task);
  const Box3 box = bounds(scene.cloud, task);
  const Vec3 middle = 0.5 * (box.min + box.max) - scene.origin;
  std::vector<ImageAxes> planes;
  for (const Vec3& normal : normals) {
    const Vec3 n = settings.projection == RasterProjection::kGiven
                       ? normal
                       : toward_viewers(scene.cloud, scene.origin, normal, middle);
    const SurfaceAxes axes = plane_axes(n);
    planes.push_back({axes.u, axes.v, n});
  }
  return planes;
}

// How many pixels' edges make one of those that large planes are found on: what is found there as one lies no farther
// apart than what merging joins. 1: none are looked for.
uint32_t coarse_edges(const SegmentScene& scene) {
  if (scene.size() < kLeastForLarge || !scene.settings.connectivity) return 1;
  const double most = scene.settings.merge_gap_m / (kCoarsePixelsPerGap * image_pixel_m(scene));
  return static_cast<uint32_t>(std::clamp(most, 1.0, static_cast<double>(kMostCoarseEdges)));
}

// Large planes first, among few points and on wide pixels: most points are theirs, and the rasters of the points left
// are small. Each gets its points among all.
uint32_t find_large(SegmentScene& scene, const RasterSettings& settings,
                    std::span<const ImageAxes> axes, Task& task) {
  const uint32_t edges = coarse_edges(scene);
  if (edges == 1) return 0;
  const RasterScale scale{edges * edges, static_cast<double>(edges), kLeastCoarsePixels, false};
  const uint32_t found = search_rasters(scene, settings, axes, scale, 1, task);
  std::vector<Surface> surfaces = surfaces_of_owners(scene, found, task);
  std::erase_if(surfaces, [](const Surface& s) { return s.positions.empty(); });
  const double widest_m = scene.settings.merge_gap_m / kCoarsePixelsPerGap;
  for (Surface& surface : surfaces)
    surface.pixel_m = std::max(surface.pixel_m, std::min(edges * surface.pixel_m, widest_m));
  assign_points(scene, surfaces, task);
  return static_cast<uint32_t>(surfaces.size());
}

uint32_t grow_all_rasters(SegmentScene& scene, const RasterSettings& settings, Task& task) {
  const std::vector<ImageAxes> axes = planes_of_projection(scene, settings, task);
  const uint32_t large = [&] {
    ProgressSpan span(task, 0, 0.3, "growing on rasters");
    return find_large(scene, settings, axes, task);
  }();
  ProgressSpan span(task, 0.3, 1, "growing on rasters");
  return large + search_rasters(scene, settings, axes, {}, large + 1, task);
}

}  // namespace

std::span<const ParamRow> raster_growing_rows() { return kRasterRows; }

// Region growing on depth images (the first of three methods for planes compared in France in 2006):
// 1. planes of projection, from the directions that most surfaces look in; 2. for each a raster of the points that are
// left, grey value = depth; 3. regions grown from the flattest windows, their points taken: of large clouds large
// planes on wide pixels first, then whatever is left; 4. coplanar pieces joined, points shared out among all planes,
// last fit.
Segmentation segment_raster_growing(const CloudPtr& cloud, const RasterSettings& settings,
                                    Task& task) {
  require_area(*cloud, task);
  SegmentScene scene = [&] {
    ProgressSpan span(task, 0, 0.3, "indexing");
    return scene_with_cells(*cloud, settings.surface, task);
  }();
  std::vector<Surface> surfaces = [&] {
    ProgressSpan span(task, 0.3, 0.7, "growing on rasters");
    const uint32_t planes = grow_all_rasters(scene, settings, task);
    return surfaces_of_owners(scene, planes, task);
  }();
  ProgressSpan span(task, 0.7, 1, "sharing out points");
  Segmentation out = settled_segmentation(cloud, scene, surfaces, task);
  out.parameters_json = settings_json(raster_growing_rows(), settings);
  return out;
}

}  // namespace jalon
