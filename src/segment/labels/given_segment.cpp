// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/labels/given_segment.h"

#include <algorithm>
#include <cmath>

#include "base/numbers.h"
#include "base/parallel.h"
#include "segment/surface/connectivity.h"

namespace jalon {

namespace {

constexpr size_t kGivenSegmentPointsPerChunk = 1 << 15;
constexpr double kPointsPerPixel = 4;  // connectivity.cpp: pixels of twice the spacing
constexpr int kPixelRounds = 6;
constexpr double kPixelSettled = 0.05;  // relative change that ends the rounds

Segment without_plane(uint64_t n) {
  Segment segment;
  const Vec3 nowhere{kNaN, kNaN, kNaN};
  PlaneFit& fit = segment.fit;
  fit.plane = {nowhere, kNaN};
  fit.centroid = fit.axis_u = fit.axis_v = nowhere;
  fit.eigenvalues.fill(kNaN);
  fit.covariance.fill(kNaN);
  fit.sigma = segment.area_m2 = segment.length_u_m = segment.length_v_m = kNaN;
  fit.n = n;
  return segment;
}

double occupied_m2(const Raster& raster) {
  const auto occupied =
      std::count_if(raster.pixels.begin(), raster.pixels.end(), [](uint8_t p) { return p != 0; });
  return static_cast<double>(occupied) * raster.pixel_m * raster.pixel_m;
}

// Area of the occupied pixels. Without a given pixel it starts from the whole box evenly filled and shrinks until the
// occupied part holds four points a pixel: openings and ragged borders do not count.
double area_of(std::span<const Vec2> points, double box_m2, double pixel_m) {
  if (pixel_m > 0) return occupied_m2(bounded_raster(points, pixel_m, 0));
  const double n = static_cast<double>(points.size());
  double pixel = std::sqrt(kPointsPerPixel * box_m2 / n), area = box_m2;
  for (int round = 0; round < kPixelRounds && pixel > 0; ++round) {
    area = occupied_m2(bounded_raster(points, pixel, 0));
    const double next = std::sqrt(kPointsPerPixel * area / n);
    if (std::fabs(next - pixel) <= kPixelSettled * pixel) break;
    pixel = next;
  }
  return area;
}

}  // namespace

Segment describe_given(const GivenPoints& points, double pixel_m, Task& task) {
  const size_t n = points.indices.size();
  Segment segment = without_plane(n);
  if (n == 0) return segment;
  Moments zero;
  zero.reference = points.local(0);
  const Moments moments =
      parallel_reduce(task, n, kGivenSegmentPointsPerChunk, zero, [&](size_t begin, size_t end) {
        Moments part = zero;
        for (size_t i = begin; i < end; ++i) part.add(points.local(i));
        return part;
      });
  if (!fit_plane(moments, segment.fit)) return segment;
  const PlaneFit& fit = segment.fit;
  std::vector<Vec2> flat(n);
  parallel_for(task, n, kGivenSegmentPointsPerChunk, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      const Vec3 d = points.local(i) - fit.centroid;
      flat[i] = {dot(d, fit.axis_u), dot(d, fit.axis_v)};
    }
  });
  Vec2 low = flat[0], high = flat[0];
  for (const Vec2& p : flat) {
    low = {std::min(low.u, p.u), std::min(low.v, p.v)};
    high = {std::max(high.u, p.u), std::max(high.v, p.v)};
  }
  segment.length_u_m = high.u - low.u;
  segment.length_v_m = high.v - low.v;
  segment.area_m2 = area_of(flat, segment.length_u_m * segment.length_v_m, pixel_m);
  return segment;
}

}  // namespace jalon
