// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "segment/raster/depth_image.h"

namespace jalon {

/// How finely planes are looked for.
struct RasterScale {
  uint32_t step = 1;          ///< every so many-th point of the octree's order is looked at
  double pixels = 1;          ///< edge of a pixel, in pixels of image_pixel_m()
  uint64_t least_pixels = 0;  ///< of a region, where the least segment asks for fewer
  bool bridges = true;        ///< whether growth crosses empty pixels
};

/// Planes from rasters along each of the axes, one raster behind the other, until they find nothing worth while: their
/// points get first_id, first_id + 1 ... as scene.owner. How many they are.
uint32_t search_rasters(SegmentScene& scene, const RasterSettings& settings,
                        std::span<const ImageAxes> axes, const RasterScale& scale,
                        uint32_t first_id, Task& task);

}  // namespace jalon
