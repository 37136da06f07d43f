// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/settle/splitting.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"
#include "segment/surface/connectivity.h"

namespace jalon {

namespace {

constexpr double kMostReach = 256;  // pixels

struct SplittingPart {
  std::vector<uint32_t> positions;
  uint64_t pixels = 0;
};

/// The connected parts of a surface, the one of most pixels first.
std::vector<SplittingPart> parts_of(const SegmentScene& scene, const Surface& surface,
                                    double& pixel_area_m2, Task& task) {
  const std::vector<Vec2> uv = flat_points(scene, surface, task);
  // Dilation by r joins what is up to 2 r empty pixels apart: no less than connectivity and merging have joined.
  const double gap = std::max(scene.settings.gap_m, scene.settings.merge_gap_m);
  const auto reach =
      static_cast<uint32_t>(std::min(kMostReach, std::ceil(gap / (2 * surface.pixel_m))));
  const Raster raster = bounded_raster(uv, surface.pixel_m, reach, task);
  const Regions regions = label_regions(dilated(raster, reach));
  pixel_area_m2 = raster.pixel_m * raster.pixel_m;
  std::vector<SplittingPart> parts(regions.count());
  for (size_t p = 0; p < raster.size(); ++p)
    if (raster.pixels[p] != 0) ++parts[regions.labels[p] - 1].pixels;
  for (size_t i = 0; i < uv.size(); ++i)
    parts[regions.labels[raster.pixel_of(uv[i])] - 1].positions.push_back(surface.positions[i]);
  std::stable_sort(parts.begin(), parts.end(), [](const SplittingPart& a, const SplittingPart& b) {
    return a.pixels > b.pixels;
  });
  return parts;
}

}  // namespace

bool split_surfaces(SegmentScene& scene, std::vector<Surface>& surfaces, Task& task) {
  const size_t least = std::max<size_t>(3, scene.settings.min_points);
  std::vector<std::vector<Surface>> apart(surfaces.size());
  std::vector<uint8_t> changed(surfaces.size(), 0);
  parallel_for(task, surfaces.size(), 1, [&](size_t s, size_t) {
    double pixel_area_m2 = 0;
    std::vector<SplittingPart> parts = parts_of(scene, surfaces[s], pixel_area_m2, task);
    if (parts.size() < 2) return;
    changed[s] = 1;
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
