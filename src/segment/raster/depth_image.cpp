// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/raster/depth_image.h"

#include <algorithm>
#include <numeric>

#include "segment/raster/layers.h"

namespace jalon {

namespace {

// Two points a pixel on average leave 15 % of the pixels empty, which growth crosses; larger ones lose what is narrow.
constexpr double kSpacingsPerImagePixel = 1.4;

}  // namespace

DepthImage depth_image(const SegmentScene& scene, const RasterSettings& settings,
                       const ImageAxes& axes, double pixel_m, Task& task) {
  std::vector<uint32_t> all(scene.size());
  std::iota(all.begin(), all.end(), 0u);
  RasterLayers layers(scene, settings, all);
  layers.look_along(axes, pixel_m, task);
  return layers.image();
}

double image_pixel_m(const SegmentScene& scene, const SpacingSample& spacings) {
  if (scene.settings.pixel_m > 0) return scene.settings.pixel_m;
  return std::max(scene.settings.distance_tolerance_m,
                  kSpacingsPerImagePixel * spacings.median_m(scene));
}

double image_pixel_m(const SegmentScene& scene) {
  return image_pixel_m(scene, SpacingSample(scene));
}

}  // namespace jalon
