// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "report/pictures/depth_picture.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.h"
#include "base/text_number.h"
#include "formats/drawings/png_writer.h"

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

}  // namespace

std::string depth_png(const DepthMap& map) {
  float near = std::numeric_limits<float>::infinity(), far = 0;
  for (const DepthMap::Cell& cell : map.cells())
    if (cell.range_m > 0) {
      near = std::min(near, cell.range_m);
      far = std::max(far, cell.range_m);
    }
  if (!(far > 0)) fail(Status::kInsufficientData, "a depth map of a station without points");

  const AngularGrid& grid = map.grid();
  IndexedImage image{grid.columns, grid.rows, std::vector<uint8_t>(grid.size()), greys(), {}};
  const double span = std::log(far / near);
  for (size_t row = 0; row < grid.rows; ++row)
    for (size_t column = 0; column < grid.columns; ++column) {
      const float range = map.cells()[row * grid.columns + column].range_m;
      const double part = span > 0 ? std::log(std::max(range, near) / near) / span : 0;
      image.pixels[(grid.rows - 1 - row) * grid.columns + column] =
          range > 0 ? static_cast<uint8_t>(std::lround(255 - part * (255 - kFarthestGrey)))
                    : uint8_t{0};
    }
  image.description = "Depth map: grey 255 = " + text_of(double{near}) + " m, " +
                      std::to_string(kFarthestGrey) + " = " + text_of(double{far}) +
                      " m, even in the logarithm of the range; blue = empty";
  return png_of(image);
}

}  // namespace jalon
