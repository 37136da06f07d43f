// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/surface/connectivity.h"

#include <algorithm>
#include <cmath>

#include "spatial/region_runs.h"

namespace jalon {

namespace {

constexpr double kMaxPixels = 1 << 24;  // 16 MiB; longer scenes get coarser pixels
constexpr uint32_t kMaxGapPixels = 256;

void empty(Raster& raster, const RegionRuns::Run& run) {
  std::fill(raster.pixels.begin() + run.begin, raster.pixels.begin() + run.end, uint8_t{0});
}

// Keeps the regions of at least `least` pixels, and the largest one in any case.
void drop_small(Raster& raster, const RegionRuns& regions, uint64_t least) {
  for (const RegionRuns::Run& run : regions.runs)
    if (run.label > 1 && regions.pixel_counts[run.label] < least) empty(raster, run);
}

// Empties what is narrower than the width: a morphological opening of the image, whose single empty pixels are filled
// first so that they do not eat the surface.
void cut_strips(Raster& raster, double width_m) {
  const double pixels = std::ceil(width_m / raster.pixel_m);
  const auto radius = static_cast<uint32_t>(
      std::clamp(std::floor(pixels / 2), 1.0, static_cast<double>(kMaxGapPixels)));
  const Raster kept = opened(closed(raster, 1), radius);
  for (size_t i = 0; i < raster.size(); ++i) raster.pixels[i] &= kept.pixels[i];
}

// Label of the group with most occupied pixels; ties to the smaller label.
uint32_t largest_group(const Raster& occupied, const RegionRuns& groups, uint64_t& pixels) {
  std::vector<uint64_t> counts(groups.count() + 1, 0);
  for (const RegionRuns::Run& run : groups.runs)
    counts[run.label] += static_cast<uint64_t>(
        std::count(occupied.pixels.begin() + run.begin, occupied.pixels.begin() + run.end, 1));
  uint32_t best = 0;
  pixels = 0;
  for (uint32_t label = 1; label < counts.size(); ++label)
    if (counts[label] > pixels) {
      best = label;
      pixels = counts[label];
    }
  return best;
}

}  // namespace

Raster empty_raster(const FlatBox& box, double pixel_m, uint32_t margin) {
  const Vec2 corners[] = {box.low, box.high};
  Raster raster = bounded_raster(corners, pixel_m, margin);
  std::fill(raster.pixels.begin(), raster.pixels.end(), uint8_t{0});
  return raster;
}

FlatFrame plane_frame(const Plane& plane, const Vec3& near) {
  const SurfaceAxes axes = plane_axes(plane.normal);
  return {near, axes.u, axes.v};
}

double occupied_area_m2(const Raster& raster) {
  const auto pixels = std::count(raster.pixels.begin(), raster.pixels.end(), uint8_t{1});
  return static_cast<double>(pixels) * raster.pixel_m * raster.pixel_m;
}

double bounded_pixel(const FlatBox& box, double pixel_m, uint32_t margin) {
  const auto pixels = [&](double edge) {
    const double border = 1 + 2.0 * margin;
    return ((box.high.u - box.low.u) / edge + border) * ((box.high.v - box.low.v) / edge + border);
  };
  while (pixels(pixel_m) > kMaxPixels) pixel_m *= 2;
  return pixel_m;
}

Raster bounded_raster(std::span<const Vec2> points, double pixel_m, uint32_t margin) {
  FlatBox box;
  for (const Vec2& p : points) box.add(p);
  return rasterise(points, bounded_pixel(box, pixel_m, margin), margin);
}

Raster bounded_raster(std::span<const Vec2> points, double pixel_m, uint32_t margin, Task& task) {
  return bounded_raster_of(
      points.size(), [&](size_t i) { return points[i]; }, pixel_m, margin, task);
}

RegionRaster::RegionRaster(const FlatBox& box, const RegionRule& rule)
    : rule_(rule),
      low_(box.low),
      gap_pixels_(static_cast<uint32_t>(
          std::min<double>(kMaxGapPixels, std::floor(rule.gap_m / (2 * rule.pixel_m))))),
      margin_(std::max(gap_pixels_, rule.strip_width_m > 0 ? 1u : 0u)) {
  raster_ = empty_raster(box, rule.pixel_m, margin_);
}

double RegionRaster::settle() {
  // Square dilation by r joins pieces up to 2 r empty pixels apart.
  if (rule_.strip_width_m > 0) cut_strips(raster_, rule_.strip_width_m);
  const double pixel_area = raster_.pixel_m * raster_.pixel_m;
  RegionRuns regions = region_runs(raster_);
  if (gap_pixels_ > 0 && regions.count() > 1) {
    drop_small(raster_, regions, static_cast<uint64_t>(std::ceil(rule_.min_piece_m2 / pixel_area)));
    regions = region_runs(dilated(raster_, gap_pixels_));
  }
  uint64_t pixels = 0;
  const uint32_t best = largest_group(raster_, regions, pixels);
  for (const RegionRuns::Run& run : regions.runs)
    if (run.label != best) empty(raster_, run);
  return static_cast<double>(pixels) * pixel_area;
}

bool RegionRaster::holds(const Vec2& p) const { return raster_.pixels[raster_.pixel_of(p)] != 0; }

Region largest_region(std::span<const Vec2> points, const RegionRule& rule) {
  Region region;
  if (points.empty()) return region;
  FlatBox box;
  for (const Vec2& p : points) box.add(p);
  RegionRaster raster(box, rule);
  for (const Vec2& p : points) raster.mark(p);
  region.area_m2 = raster.settle();
  for (size_t i = 0; i < points.size(); ++i)
    if (raster.holds(points[i])) region.members.push_back(static_cast<uint32_t>(i));
  return region;
}

}  // namespace jalon
