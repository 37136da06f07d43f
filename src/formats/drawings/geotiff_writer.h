// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/task.h"
#include "formats/drawings/pixels.h"

namespace jalon {

/// Where a raster lies in a local system in metres: y upward, rows downward.
struct RasterPlace {
  double left_m = 0, top_m = 0;  ///< of the outer corner of the first pixel
  double pixel_m = 1;
  std::string system;  ///< what the coordinates are, in ASCII
  uint16_t epsg = 0;   ///< of the projected system that they are in; 0: a local one
};

/// Where a raster lies whose axes are angles: to the right clockwise, upward from the horizon. No system of GeoTIFF is
/// of that kind, and none is named.
struct AngularPlace {
  double left_deg = 0, top_deg = 0;  ///< of the outer corner of the first pixel
  double width_deg = 1, height_deg = 1;
  std::string description;  ///< in ASCII
};

/// One number a pixel, row by row from the top; NaN where there is none.
struct NumberImage {
  uint32_t width = 0, height = 0;
  std::vector<float> pixels;
};

constexpr float kNoNumber =
    -9999;  // what stands for NaN in the file: not all programs know a NaN as no-data

/// GeoTIFF 1.1 (OGC 19-008r4) in a little-endian TIFF 6.0 with deflated strips: red, green, blue and opacity, or
/// float32 with GDAL's tag of the no-data value. Its system is user-defined, in metres: GDAL makes a local one of it.
/// The same bytes for any number of threads.
std::string geotiff_of(const RgbaImage& image, const RasterPlace& place, Task& task);
std::string geotiff_of(const NumberImage& image, const RasterPlace& place, Task& task);
std::string geotiff_of(const NumberImage& image, const AngularPlace& place, Task& task);

}  // namespace jalon
