// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <limits>

#include "base/text_number.h"
#include "formats/drawings/depth_image.h"
#include "formats/drawings/geotiff_writer.h"
#include "formats/files/atomic_file.h"
#include "formats/tiff/tiff.h"
#include "formats/units/crs_code.h"

namespace jalon {

namespace {

constexpr double kExactDepth_m = 10000;     // float32 has steps of 1 mm up to 16 384 m
constexpr uint32_t kMostShortCode = 32766;  // of a GeoKey; 32767 is "user-defined"

bool is_from_above(const DepthAxes& axes) { return axes.u.x == 1 && axes.v.y == 1; }

RasterPlace place_of(const Cloud& cloud, const DepthRaster& image, double base_m) {
  RasterPlace place{image.low[0], image.low[1] + image.rows * image.pixel_m, image.pixel_m, {}};
  if (is_from_above(image.axes)) {
    place.system = "heights of the nearest points";
    const uint32_t code = metric_epsg_code(cloud.crs.str());
    if (code <= kMostShortCode) place.epsg = static_cast<uint16_t>(code);
  } else {
    const Vec3& n = image.axes.n;
    place.system = "depth image seen from " + text_of(n.x) + " " + text_of(n.y) + " " +
                   text_of(n.z) + ": metres toward the viewer, x and y along the image";
  }
  if (base_m != 0) place.system += ", values count from " + text_of(base_m) + " m";
  return place;
}

}  // namespace

void write_depth_tiff(const Cloud& cloud, const std::string& path, const WriteSettings& settings,
                      Task& task) {
  ProgressSpan span(task, 0, 0.99, "writing GeoTIFF");
  const DepthRaster image = depth_image_of(cloud, settings, path, task);
  const double base_m = std::fabs(image.low[2]) > kExactDepth_m ? std::floor(image.low[2]) : 0;
  NumberImage numbers{image.columns, image.rows, {}};
  numbers.pixels.reserve(image.depths.size());
  for (const double depth : image.depths)
    numbers.pixels.push_back(depth == kNoDepth ? std::numeric_limits<float>::quiet_NaN()
                                               : static_cast<float>(depth - base_m));
  AtomicFile file(path);
  file.write(geotiff_of(numbers, place_of(cloud, image, base_m), task));
  file.commit();
}

}  // namespace jalon
