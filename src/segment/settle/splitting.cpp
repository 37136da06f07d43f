// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/settle/splitting.h"

#include <algorithm>
#include <cmath>

#include "segment/settle/each_surface.h"
#include "segment/surface/connectivity.h"
#include "spatial/region_runs.h"

namespace jalon {

namespace {

constexpr double kMostReach = 256;  // pixels

struct SplittingPart {
  std::vector<uint32_t> positions;
  uint64_t pixels = 0;
};

// at(i): where the i-th of the surface's points lies on it. None where the surface is of one part, as most are.
template <class At>
std::vector<SplittingPart> parts_at(const SegmentScene& scene, const Surface& surface, const At& at,
                                    double& pixel_area_m2, Task& task) {
  // Dilation by r joins what is up to 2 r empty pixels apart: no less than connectivity and merging have joined.
  const double gap = std::max(scene.settings.gap_m, scene.settings.merge_gap_m);
  const auto reach =
      static_cast<uint32_t>(std::min(kMostReach, std::ceil(gap / (2 * surface.pixel_m))));
  const size_t n = surface.positions.size();
  const Raster raster = bounded_raster_of(n, at, surface.pixel_m, reach, task);
  const Raster joined = dilated(raster, reach);
  if (region_runs(joined).count() < 2) return {};
  const Regions regions = label_regions(joined);
  pixel_area_m2 = raster.pixel_m * raster.pixel_m;
  std::vector<SplittingPart> parts(regions.count());
  for (size_t p = 0; p < raster.size(); ++p)
    if (raster.pixels[p] != 0) ++parts[regions.labels[p] - 1].pixels;
  for (size_t i = 0; i < n; ++i)
    parts[regions.labels[raster.pixel_of(at(i))] - 1].positions.push_back(surface.positions[i]);
  std::stable_sort(parts.begin(), parts.end(), [](const SplittingPart& a, const SplittingPart& b) {
    return a.pixels > b.pixels;
  });
  return parts;
}

/// The connected parts of a surface, the one of most pixels first.
std::vector<SplittingPart> parts_of(const SegmentScene& scene, const Surface& surface,
                                    double& pixel_area_m2, Task& task) {
  if (surface.is_plane()) {
    const FlatFrame frame = plane_frame(surface.plane, scene.local(surface.positions[0]));
    const auto at = [&](size_t i) { return frame(scene.local(surface.positions[i])); };
    return parts_at(scene, surface, at, pixel_area_m2, task);
  }
  const std::vector<Vec2> uv = flat_points(scene, surface, task);
  return parts_at(
      scene, surface, [&](size_t i) { return uv[i]; }, pixel_area_m2, task);
}

}  // namespace

bool split_surfaces(SegmentScene& scene, std::vector<Surface>& surfaces, Task& task) {
  const size_t least = std::max<size_t>(3, scene.settings.min_points);
  std::vector<std::vector<Surface>> apart(surfaces.size());
  std::vector<uint8_t> changed(surfaces.size(), 0);
  for_each_surface(surfaces, task, [&](size_t s) {
    double pixel_area_m2 = 0;
    std::vector<SplittingPart> parts = parts_of(scene, surfaces[s], pixel_area_m2, task);
    if (parts.size() < 2) return;
    changed[s] = 1;
    surfaces[s].image = {};
    surfaces[s].sharing.fresh = true;
    surfaces[s].sharing.moved = Surface::Sharing::kAll;
    surfaces[s].positions = std::move(parts[0].positions);
    for (size_t k = 1; k < parts.size(); ++k) {
      SplittingPart& part = parts[k];
      const double area_m2 = static_cast<double>(part.pixels) * pixel_area_m2;
      if (part.positions.size() < least || area_m2 < scene.settings.min_area_m2) {
        for (const uint32_t position : part.positions) scene.owner[position] = 0;
        continue;
      }
      apart[s].push_back(surfaces[s]);
      apart[s].back().area_m2 = area_m2;
      apart[s].back().sharing = {};
      apart[s].back().positions = std::move(part.positions);
    }
  });
  for (std::vector<Surface>& parts : apart)
    for (Surface& part : parts) surfaces.push_back(std::move(part));
  return std::find(changed.begin(), changed.end(), 1) != changed.end();
}

}  // namespace jalon
