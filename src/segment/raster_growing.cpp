// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/parallel.h"
#include "base/setting_rows.h"
#include "base/settings_json.h"
#include "segment/plane_rows.h"
#include "segment/raster/depth_image.h"
#include "segment/raster/directions.h"
#include "segment/raster/layers.h"
#include "segment/raster/pixel_growth.h"
#include "segment/raster_settings.h"
#include "segment/settle/ending.h"
#include "segment/settle/found_planes.h"

namespace jalon {

namespace {

constexpr uint32_t kBridgedPixels = 2;  // of gap_m = 0
constexpr uint32_t kMostReach = 64;     // pixels: a ray is followed no farther
constexpr double kLeastRegion = 0.25;   // of the least segment: such pieces may be joined
// Between pixels that fit the points left and those that fitted the points before: then the raster is made anew, so
// that those wait no longer that stood too far apart. Anything from 1.1 to 1.4 does as well on S1, S3, S11, the street.
constexpr double kOtherDensity = 1.25;
constexpr size_t kRasterPixelsPerChunk = 1 << 12;

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

PixelRule rule_of(const RasterSettings& settings, const DepthImage& image, uint32_t min_points,
                  size_t free_points) {
  PixelRule rule;
  rule.tolerance_m = std::max(settings.surface.distance_tolerance_m, image.quantum_m);
  rule.seed_pixels = settings.seed_pixels | 1u;
  const double bridged = settings.gap_m > 0 ? std::floor(settings.gap_m / image.pixel_m)
                                            : static_cast<double>(kBridgedPixels);
  rule.reach_pixels = 1 + static_cast<uint32_t>(std::min<double>(kMostReach, bridged));
  const double filled =
      static_cast<double>(std::count(image.occupied.begin(), image.occupied.end(), uint8_t{1}));
  const double by_area = settings.surface.min_area_m2 / (image.pixel_m * image.pixel_m);
  const double by_points = min_points * filled / static_cast<double>(free_points);
  rule.least_pixels = static_cast<uint64_t>(
      std::max(rule.seed_pixels * 2.0, kLeastRegion * std::max(by_area, by_points)));
  return rule;
}

// The free points of the regions' pixels that lie in their planes; the pixels where there were such.
struct TakenPoints {
  size_t points = 0;
  std::vector<uint32_t> pixels;
  TakenPoints& operator+=(const TakenPoints& b) {
    points += b.points;
    pixels.insert(pixels.end(), b.pixels.begin(), b.pixels.end());
    return *this;
  }
};

TakenPoints take_points(SegmentScene& scene, const RasterLayers& layers,
                        const PixelRegions& regions, double tolerance_m, uint32_t first_id,
                        Task& task) {
  const double cosine = scene.min_cosine();
  return parallel_reduce(task, regions.pixels.size(), kRasterPixelsPerChunk, TakenPoints{},
                         [&](size_t begin, size_t end) {
                           TakenPoints taken;
                           for (size_t k = begin; k < end; ++k) {
                             const size_t before = taken.points;
                             const uint32_t label = regions.labels[k];
                             const Plane& plane = regions.planes[label - 1];
                             for (const uint32_t i : layers.points_of(regions.pixels[k])) {
                               if (scene.owner[i] != 0 ||
                                   std::fabs(plane.distance(scene.local(i))) > tolerance_m ||
                                   scene.inconsistent(i, plane.normal, cosine))
                                 continue;
                               scene.owner[i] = first_id + label - 1;
                               ++taken.points;
                             }
                             if (taken.points > before) taken.pixels.push_back(regions.pixels[k]);
                           }
                           return taken;
                         });
}

// Rasters along one direction until one takes nothing worth while: behind the first, regions start where the one
// before took what stood in front, as long as the points left are about as dense. How many points are left.
size_t grow_along(SegmentScene& scene, const RasterSettings& settings, const ImageAxes& axes,
                  size_t free_points, uint32_t& planes, Task& task) {
  RasterLayers layers(scene, settings);
  PixelGrowth growth;
  TakenPoints taken;
  double pixel_m = 0;
  const DepthImage& image = layers.image();
  for (uint32_t layer = 0; layer < settings.layers; ++layer) {
    if (free_points < std::max<size_t>(3, settings.surface.min_points)) break;
    ProgressSpan span(task, static_cast<double>(layer) / settings.layers,
                      (layer + 1.0) / settings.layers);
    const double own_m = image_pixel_m(scene);
    const bool anew = own_m > kOtherDensity * pixel_m || own_m * kOtherDensity < pixel_m;
    if (anew) layers.look_along(axes, pixel_m = own_m, task);
    else layers.look_behind(taken.pixels, task);
    const PixelRule rule = rule_of(settings, image, settings.surface.min_points, free_points);
    const std::vector<uint32_t> seeds =
        anew ? pixel_seeds(image, rule, task) : pixel_seeds(image, rule, taken.pixels, task);
    const PixelRegions regions = growth.grow(image, rule, seeds, task);
    taken = take_points(scene, layers, regions, rule.tolerance_m, planes + 1, task);
    planes += static_cast<uint32_t>(regions.planes.size());
    free_points -= taken.points;
    if (taken.points < settings.surface.min_points || taken.points == 0) break;
  }
  return free_points;
}

uint32_t grow_all_rasters(SegmentScene& scene, const RasterSettings& settings, Task& task) {
  const std::vector<ImageAxes> axes = planes_of_projection(scene, settings, task);
  const auto parts = static_cast<double>(axes.size());
  auto free_points = static_cast<size_t>(std::count(scene.owner.begin(), scene.owner.end(), 0u));
  uint32_t planes = 0;
  for (size_t d = 0; d < axes.size(); ++d) {
    const auto part = static_cast<double>(d);
    ProgressSpan span(task, part / parts, (part + 1) / parts, "growing on rasters");
    free_points = grow_along(scene, settings, axes[d], free_points, planes, task);
  }
  return planes;
}

}  // namespace

std::span<const ParamRow> raster_growing_rows() { return kRasterRows; }

// Region growing on depth images (the first of three methods for planes compared in France in 2006):
// 1. planes of projection, from the directions that most surfaces look in; 2. for each a raster of the points that are
// left, grey value = depth; 3. regions grown from the flattest windows, their points taken; 4. coplanar pieces joined,
// points shared out among all planes, last fit.
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
