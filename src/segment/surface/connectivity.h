// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "base/parallel.h"
#include "base/task.h"
#include "segment/surface/nth_value.h"
#include "segment/surface/scene.h"
#include "spatial/raster.h"

namespace jalon {

/// Projection of local coordinates on a plane.
struct FlatFrame {
  Vec3 centre, u, v;
  Vec2 operator()(const Vec3& p) const { return {dot(p - centre, u), dot(p - centre, v)}; }
};
FlatFrame plane_frame(const Plane& plane, const Vec3& near);

/// One connected surface among points on a plane.
struct Region {
  std::vector<uint32_t> members;  ///< indices into the points given, ascending
  double area_m2 = 0;             ///< occupied pixels
};

/// Pixel of the connectivity raster: the user's, or twice the spacing (its 80th percentile among the points, since
/// holes of the raster matter where points are sparse), never below the tolerance, which is as fine as the plane
/// itself is known. spacing_at(0) ... spacing_at(n - 1) from any thread.
template <class At>
double connectivity_pixel(const SurfaceSettings& settings, size_t n, const At& spacing_at,
                          Task& task) {
  constexpr double kSpacingsPerPixel =
      2;  // 4 points a pixel on average: 2 % of the pixels of a surface stay empty
  constexpr double kSpacingPercentile = 0.8;
  if (settings.pixel_m > 0) return settings.pixel_m;
  if (n == 0) return settings.distance_tolerance_m;
  const auto nth = static_cast<size_t>(kSpacingPercentile * static_cast<double>(n - 1));
  return std::max(settings.distance_tolerance_m,
                  kSpacingsPerPixel * static_cast<double>(nth_value(n, nth, spacing_at, task)));
}

/// What makes a surface one.
struct RegionRule {
  double pixel_m = 0;
  double gap_m = 0;
  double min_piece_m2 = 0;
  double strip_width_m = 0;
};

/// The largest region by area (Boulaassal 2010, 3.4.6): occupied pixels, 8-neighbourhood; pieces of at least
/// min_piece_m2 that come within gap_m of each other count as one region, smaller ones belong to it only when they
/// touch. Parts narrower than strip_width_m are cut off first: the line of points where the plane cuts another surface
/// touches the surface sought and would come with it.
Region largest_region(std::span<const Vec2> points, const RegionRule& rule);

/// Extent of points on a surface.
struct FlatBox {
  Vec2 low{INFINITY, INFINITY}, high{-INFINITY, -INFINITY};
  void add(const Vec2& p) { *this += {p, p}; }
  FlatBox& operator+=(const FlatBox& b) {
    low = {std::min(low.u, b.low.u), std::min(low.v, b.low.v)};
    high = {std::max(high.u, b.high.u), std::max(high.v, b.high.v)};
    return *this;
  }
};

/// An image as rasterise() makes it of points with this extent, all of it empty.
Raster empty_raster(const FlatBox& box, double pixel_m, uint32_t margin);

/// The pixel that rasterise() gives a point: relative to the lowest corner, so that the margin has no say. From any
/// thread.
inline void mark_pixel(Raster& raster, const Vec2& low, uint32_t margin, const Vec2& p) {
  const auto cell = [&](double offset, uint32_t cells) {
    const double at = offset / raster.pixel_m;  // cut off below, as std::floor() of what is above 0
    const uint32_t last = cells - 2 * margin - 1;
    if (!(at >= 1)) return size_t{margin};
    return size_t{margin} + (at >= static_cast<double>(last) ? last : static_cast<uint32_t>(at));
  };
  const size_t pixel =
      cell(p.v - low.v, raster.rows) * raster.columns + cell(p.u - low.u, raster.columns);
  std::atomic_ref<uint8_t>(raster.pixels[pixel]).store(1, std::memory_order_relaxed);
}

/// The same in steps, for points that nobody has listed: a list of those of the largest surface would be the peak of a
/// segmentation. 1. mark() all points, from any threads; 2. settle(); 3. holds() tells which of them belong to it.
class RegionRaster {
 public:
  /// box: of all points.
  RegionRaster(const FlatBox& box, const RegionRule& rule);
  void mark(const Vec2& p) { mark_pixel(raster_, low_, margin_, p); }
  /// Its area. Empties all pixels of others.
  double settle();
  bool holds(const Vec2& p) const;

 private:
  RegionRule rule_;
  Vec2 low_;
  uint32_t gap_pixels_, margin_;
  Raster raster_;  ///< once settled, of the largest surface alone
};

/// Area of the occupied pixels.
double occupied_area_m2(const Raster& raster);

/// The pixel, or twice it, four times ... so that the image of a box stays within a bound on memory.
double bounded_pixel(const FlatBox& box, double pixel_m, uint32_t margin);
/// The raster of points with such a pixel.
Raster bounded_raster(std::span<const Vec2> points, double pixel_m, uint32_t margin);
/// The same by all threads.
Raster bounded_raster(std::span<const Vec2> points, double pixel_m, uint32_t margin, Task& task);

/// The same of the points at(0) ... at(n - 1), which are asked for twice: of a plane they are found sooner than read.
template <class At>
Raster bounded_raster_of(size_t n, const At& at, double pixel_m, uint32_t margin, Task& task) {
  constexpr size_t kPointsPerChunk = 1 << 15;
  const FlatBox box =
      parallel_reduce(task, n, kPointsPerChunk, FlatBox{}, [&](size_t begin, size_t end) {
        FlatBox part;
        for (size_t i = begin; i < end; ++i) part.add(at(i));
        return part;
      });
  Raster raster = empty_raster(box, pixel_m, margin);
  parallel_for(task, n, kPointsPerChunk, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) mark_pixel(raster, box.low, margin, at(i));
  });
  return raster;
}

}  // namespace jalon
