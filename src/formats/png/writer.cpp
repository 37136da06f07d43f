// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "base/parallel.h"
#include "formats/drawings/depth_image.h"
#include "formats/files/atomic_file.h"
#include "formats/png/grey_file.h"
#include "formats/png/grid.h"
#include "formats/png/png.h"

namespace jalon {

namespace {

constexpr size_t kPngPixelsPerChunk = 1 << 15;

}  // namespace

void write_png(const Cloud& cloud, const std::string& path, const WriteSettings& settings,
               Task& task) {
  png::require_libpng(path);
  ProgressSpan span(task, 0, 0.99, "writing PNG");
  const DepthRaster seen = depth_image_of(cloud, settings, path, task);
  png::GreyImage image;
  image.width = seen.columns;
  image.height = seen.rows;
  image.bits = settings.png_bits == PngBits::k16 ? 16 : 8;
  const double most = std::ldexp(1.0, image.bits) - 1;  // 1 ... most are seen.depths
  const double step = seen.range_m / (most - 1);
  image.pixels.resize(seen.depths.size());
  parallel_for(task, seen.depths.size(), kPngPixelsPerChunk, [&](size_t begin, size_t end) {
    for (size_t p = begin; p < end; ++p) {
      if (seen.depths[p] == kNoDepth) continue;
      const double steps = step > 0 ? std::round((seen.depths[p] - seen.low[2]) / step) : 0;
      image.pixels[p] = static_cast<uint16_t>(1 + std::clamp(steps, 0.0, most - 1));
    }
  });
  const DepthAxes& axes = seen.axes;
  const double pixel_m = seen.pixel_m;
  const double left = seen.low[0] + 0.5 * pixel_m, top = seen.low[1] + (seen.rows - 0.5) * pixel_m;
  const png::DepthGrid grid{left * axes.u + top * axes.v + (seen.low[2] - step) * axes.n,
                            pixel_m * axes.u, -pixel_m * axes.v, step * axes.n};
  const std::string bytes = png::grey_png(image, png::kGridKeyword, png::text_of_grid(grid), task);
  AtomicFile file(path);
  file.write(bytes);
  file.commit();
}

}  // namespace jalon
