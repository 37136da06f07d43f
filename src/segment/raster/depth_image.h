// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "segment/raster_settings.h"
#include "segment/surface/scene.h"
#include "segment/surface/spacing.h"

namespace jalon {

/// What an image looks along: u and v in its plane, n toward the viewer. Depths are along n.
struct ImageAxes {
  Vec3 u, v, n;
};

/// A raster whose grey value is the distance from the plane of projection, one return a pixel.
struct DepthImage {
  struct Pixel {
    float u, v, g;  ///< of its return, or of its centre when grey values have few bits
  };
  ImageAxes axes;
  Vec2 low;
  double pixel_m = 0;
  uint32_t columns = 0, rows = 0;
  std::vector<Pixel> pixels;      ///< row by row
  std::vector<uint8_t> occupied;  ///< 0: no return
  double quantum_m = 0;           ///< step of the grey values; 0 = none

  size_t size() const { return pixels.size(); }
  /// Asked for each point of each image.
  size_t pixel_of(const Vec3& p) const {
    const auto cell = [&](double offset, uint32_t cells) {
      const double at = offset / pixel_m;
      return at > 0 ? std::min(static_cast<uint32_t>(at), cells - 1) : 0u;
    };
    return size_t{cell(dot(p, axes.v) - low.v, rows)} * columns +
           cell(dot(p, axes.u) - low.u, columns);
  }
};

/// Image of the free points; empty when there are none. The pixel doubles where the image would have more than a few
/// pixels a point. O(n), the same bits for any number of threads. For one raster after the other: layers.h.
DepthImage depth_image(const SegmentScene& scene, const RasterSettings& settings,
                       const ImageAxes& axes, double pixel_m, Task& task);

/// Pixel of the raster: the user's, or 1.4 times the median spacing of the free points, never below the tolerance.
double image_pixel_m(const SegmentScene& scene, const SpacingSample& spacings);
double image_pixel_m(const SegmentScene& scene);

}  // namespace jalon
