// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "segment/segmentation.h"
#include "segment/surface_settings.h"

namespace jalon {

/// What the points are projected on: a raster for each dominant direction of the cloud's surfaces, one for the most
/// frequent of them, or one for a given direction.
enum class RasterProjection { kDirections, kMain, kGiven };
/// Which of the points that share a pixel stands for it.
enum class PixelReturn { kNearest, kMedian };

/// The parameters of method "raster_growing"; the rows stand in raster_growing.cpp.
struct RasterSettings {
  SurfaceSettings surface;  ///< pixel_m is also that of the raster
  RasterProjection projection = RasterProjection::kDirections;
  std::vector<double> direction{0, -1, 0};  ///< normal of the given plane, toward the viewer
  uint32_t max_directions = 12;
  uint32_t layers = 16;  ///< rasters of one direction, each of the points that the last ones left
  PixelReturn returns = PixelReturn::kNearest;
  uint32_t seed_pixels = 3;
  double gap_m = 0;        ///< empty pixels that growth crosses; 0 = two pixels
  uint32_t grey_bits = 0;  ///< 0 = depths as they are
};

/// Parameter table of method "raster_growing".
std::span<const ParamRow> raster_growing_rows();
/// Planes grown on depth images (see raster_growing.cpp for the steps).
Segmentation segment_raster_growing(const CloudPtr& cloud, const RasterSettings& settings,
                                    Task& task);

}  // namespace jalon
