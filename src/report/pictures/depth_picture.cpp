// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "report/pictures/depth_picture.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "base/error.h"
#include "base/text_number.h"
#include "formats/drawings/geotiff_writer.h"
#include "formats/png/pictures.h"

namespace jalon {

namespace {

constexpr uint8_t kFarthestGrey = 30;
constexpr Rgb kEmpty{16, 32, 72};

std::vector<Rgb> greys() {
  std::vector<Rgb> palette{kEmpty};
  for (int grey = 1; grey < 256; ++grey) {
    const auto g = static_cast<uint8_t>(grey);
    palette.push_back({g, g, g});
  }
  return palette;
}

void check_cancel(const Task& task) {
  if (task.cancelled()) fail(Status::kCancelled, "cancelled");
}

}  // namespace

std::string depth_png(const DepthMap& map, Task& task) {
  float near = std::numeric_limits<float>::infinity(), far = 0;
  const AngularGrid& grid = map.grid();
  for (uint32_t row = 0; row < grid.rows; ++row) {
    check_cancel(task);
    for (uint32_t column = 0; column < grid.columns; ++column)
      if (const float range = map.cell(column, row).range_m; range > 0) {
        near = std::min(near, range);
        far = std::max(far, range);
      }
  }
  if (!(far > 0)) fail(Status::kInsufficientData, "a depth map of a station without points");

  IndexedImage image{grid.columns, grid.rows, std::vector<uint8_t>(grid.size()), greys(), {}};
  const double span = std::log(far / near);
  for (uint32_t row = 0; row < grid.rows; ++row) {
    check_cancel(task);
    for (uint32_t column = 0; column < grid.columns; ++column) {
      const float range = map.cell(column, row).range_m;
      const double part = span > 0 ? std::log(std::max(range, near) / near) / span : 0;
      image.pixels[size_t{grid.rows - 1 - row} * grid.columns + column] =
          range > 0 ? static_cast<uint8_t>(std::lround(255 - part * (255 - kFarthestGrey)))
                    : uint8_t{0};
    }
  }
  image.description = "Depth map: grey 255 = " + text_of(double{near}) + " m, " +
                      std::to_string(kFarthestGrey) + " = " + text_of(double{far}) +
                      " m, even in the logarithm of the range; blue = empty";
  return png_of(image);
}

std::string depth_tiff(const DepthMap& map, Task& task) {
  constexpr double kDegrees = 180 / std::numbers::pi;
  const AngularGrid& grid = map.grid();
  NumberImage image{grid.columns, grid.rows, std::vector<float>(grid.size(), std::nanf(""))};
  bool is_empty = true;
  for (uint32_t row = 0; row < grid.rows; ++row) {
    check_cancel(task);
    for (uint32_t column = 0; column < grid.columns; ++column)
      if (const float range = map.cell(column, row).range_m; range > 0) {
        image.pixels[size_t{grid.rows - 1 - row} * grid.columns + column] = range;
        is_empty = false;
      }
  }
  if (is_empty) fail(Status::kInsufficientData, "a depth map of a station without points");
  return geotiff_of(
      image,
      AngularPlace{grid.horizontal_from_rad * kDegrees,
                   (grid.vertical_from_rad + grid.rows * grid.vertical_step_rad) * kDegrees,
                   grid.horizontal_step_rad * kDegrees, grid.vertical_step_rad * kDegrees,
                   "Depth map: ranges in metres; x: degrees clockwise from +Y, y: "
                   "degrees above the horizon"},
      task);
}

}  // namespace jalon
