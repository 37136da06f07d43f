// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "base/task.h"
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
/// itself is known.
double connectivity_pixel(const SurfaceSettings& settings, std::vector<float> spacings);

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

/// The same in steps, for points that nobody has listed: a list of those of the largest surface would be the peak of a
/// segmentation. 1. mark() all points, from any threads; 2. settle(); 3. holds() tells which of them belong to it.
class RegionRaster {
 public:
  /// box: of all points.
  RegionRaster(const FlatBox& box, const RegionRule& rule);
  void mark(const Vec2& p);
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

}  // namespace jalon
