// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/drawings/depth_image.h"

#include <algorithm>
#include <atomic>
#include <cmath>

#include "base/error.h"
#include "base/parallel.h"
#include "base/text_number.h"

namespace jalon {

namespace {

constexpr size_t kDepthPointsPerChunk = 1 << 15;
constexpr double kPointsPerPixel = 2;  // of png_pixel_m = 0: one pixel in seven stays empty
constexpr double kLookingDown = 0.95;  // nz of a direction beyond which "up" is north

DepthAxes axes_of(const WriteSettings& settings) {
  const std::vector<double>& d = settings.png_direction;
  if (d.empty()) return {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const Vec3 n = d.size() == 3 ? normalized({d[0], d[1], d[2]}) : Vec3{};
  if (!(squared_norm(n) > 0.5))
    fail(Status::kInvalidArgument, "png_direction must be three numbers x, y, z, not all 0");
  const Vec3 up = std::fabs(n.z) < kLookingDown ? Vec3{0, 0, 1} : Vec3{0, 1, 0};
  const Vec3 u = normalized(cross(up, n));
  return {u, cross(n, u), n};
}

struct Extent {
  std::array<double, 3> low{INFINITY, INFINITY, INFINITY}, high{-INFINITY, -INFINITY, -INFINITY};
  Extent& operator+=(const Extent& b) {
    for (size_t k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], b.low[k]);
      high[k] = std::max(high[k], b.high[k]);
    }
    return *this;
  }
  double side(size_t k) const { return high[k] - low[k]; }
};

Extent extent_of(const Cloud& cloud, const DepthAxes& axes, Task& task) {
  return parallel_reduce(task, cloud.size(), kDepthPointsPerChunk, Extent{},
                         [&](size_t begin, size_t end) {
                           Extent part;
                           for (size_t i = begin; i < end; ++i) {
                             const auto at = axes.of(cloud.point(i));
                             part += Extent{at, at};
                           }
                           return part;
                         });
}

double pixel_of(const WriteSettings& settings, const Extent& extent, size_t points) {
  if (settings.png_pixel_m > 0) return settings.png_pixel_m;
  const double pixel =
      std::sqrt(kPointsPerPixel * extent.side(0) * extent.side(1) / static_cast<double>(points));
  const double of_a_line = std::max(extent.side(0), extent.side(1)) / static_cast<double>(points);
  return pixel > 0 ? pixel : of_a_line > 0 ? of_a_line : 1;
}

// Depth of the nearest point of each pixel, rows from the top.
std::vector<double> nearest_depths(const Cloud& cloud, const DepthAxes& axes, const Extent& extent,
                                   double pixel, uint32_t columns, uint32_t rows, Task& task) {
  std::vector<double> depths(size_t{columns} * rows, kNoDepth);
  const auto cell = [&](double offset, uint32_t cells) {
    return std::min(static_cast<uint32_t>(std::max(0.0, offset / pixel)), cells - 1);
  };
  parallel_for(task, cloud.size(), kDepthPointsPerChunk, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      const auto at = axes.of(cloud.point(i));
      const size_t row = rows - 1 - cell(at[1] - extent.low[1], rows);
      std::atomic_ref<double> nearest(depths[row * columns + cell(at[0] - extent.low[0], columns)]);
      double seen = nearest.load(std::memory_order_relaxed);
      while (seen < at[2] &&
             !nearest.compare_exchange_weak(seen, at[2], std::memory_order_relaxed)) {
      }
    }
  });
  return depths;
}

}  // namespace

DepthRaster depth_image_of(const Cloud& cloud, const WriteSettings& settings,
                           const std::string& path, Task& task) {
  const DepthAxes axes = axes_of(settings);
  if (cloud.size() == 0)
    fail(Status::kInsufficientData, "%.400s: a depth image needs points, this cloud has none",
         path.c_str());
  const Extent extent = extent_of(cloud, axes, task);
  const double pixel = pixel_of(settings, extent, cloud.size());
  if (!std::isfinite(pixel) || !std::isfinite(extent.side(2)))
    fail(Status::kLimit, "%.400s: the points lie too far apart for an image", path.c_str());
  const double columns = std::floor(extent.side(0) / pixel) + 1,
               rows = std::floor(extent.side(1) / pixel) + 1;
  if (!(columns * rows <= static_cast<double>(kMostDepthPixels)))
    fail(Status::kLimit, "%.400s: pixels of %s m make an image of %s x %s; take larger ones",
         path.c_str(), text_of(pixel).c_str(), text_of(columns).c_str(), text_of(rows).c_str());
  DepthRaster image{axes,
                    extent.low,
                    extent.side(2),
                    pixel,
                    static_cast<uint32_t>(columns),
                    static_cast<uint32_t>(rows),
                    {}};
  image.depths = nearest_depths(cloud, axes, extent, pixel, image.columns, image.rows, task);
  return image;
}

}  // namespace jalon
