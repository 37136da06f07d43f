// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "report/pictures/label_raster.h"

#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>

#include "base/parallel.h"
#include "cloud/statistics.h"

namespace jalon {

namespace {

constexpr size_t kPointsPerChunk = 1 << 16;
constexpr double kCoarseCells =
    256;  // at most, along the longer side, to see how much of the picture is covered
constexpr double kPointsPerCell = 9;  // so that surfaces have no empty cells (e^-9)
constexpr double kPixelsPerSpacing =
    2;  // a point is 3 pixels wide then: surfaces close, edges swell by 3/4 spacing
constexpr double kLeastExtent_m = 0.01;
constexpr double kMostExtent_m = 1e9;  // 25 times round the Earth: squares of more may overflow
constexpr int kClosingNeighbours = 5;  // of 8: a hole of one pixel in a surface

using Labels = std::span<const uint32_t>;

// From any thread.
void set(uint8_t& flag) { std::atomic_ref<uint8_t>(flag).store(1, std::memory_order_relaxed); }

// Front: along the facade and the height Z of the data, the eye at the station side. Plan: X and Y, the eye above.
Projection projection_of(const Segmentation& s, PictureView view, Task& task) {
  const Vec3 o = local_origin(*s.cloud, task);
  if (view == PictureView::kPlan) return {o, {1, 0, 0}, {0, 1, 0}, {0, 0, -1}, {o.x, o.y}};
  const auto& m = s.T_facade_world.m;
  const Vec3 along{m[0], m[1], m[2]};
  return {o, along, {0, 0, 1}, {m[4], m[5], m[6]}, {dot(along, o) + m[3], o.z}};
}

struct Extent {
  Vec2 low{INFINITY, INFINITY}, high{-INFINITY, -INFINITY};
  uint64_t n = 0;
  void add(const Vec2& p) {
    low = {std::min(low.u, p.u), std::min(low.v, p.v)};
    high = {std::max(high.u, p.u), std::max(high.v, p.v)};
    ++n;
  }
  Extent& operator+=(const Extent& b) {
    low = {std::min(low.u, b.low.u), std::min(low.v, b.low.v)};
    high = {std::max(high.u, b.high.u), std::max(high.v, b.high.v)};
    n += b.n;
    return *this;
  }
};

Extent extent_of(const Cloud& cloud, Labels labels, const Projection& projection, bool noise_too,
                 Task& task) {
  return parallel_reduce(task, labels.size(), kPointsPerChunk, Extent{},
                         [&](size_t begin, size_t end) {
                           Extent part;
                           for (size_t i = begin; i < end; ++i)
                             if (noise_too || labels[i] != 0)
                               part.add(projection.flat(cloud.point(i)));
                           return part;
                         });
}

// Spacing of the points on the picture, from the part of it that they cover.
double spacing_of(const Cloud& cloud, const Projection& projection, const Extent& box, Task& task) {
  const double width = box.high.u - box.low.u, height = box.high.v - box.low.v;
  const double n = static_cast<double>(std::max<uint64_t>(1, box.n));
  const double cell = std::max(std::max({width, height, kLeastExtent_m}) / kCoarseCells,
                               std::sqrt(kPointsPerCell * width * height / n));
  const auto side = static_cast<size_t>(kCoarseCells) + 1;
  std::vector<uint8_t> covered(side * side, 0);
  parallel_for(task, cloud.size(), kPointsPerChunk, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      const Vec2 p = projection.flat(cloud.point(i));
      const double u = (p.u - box.low.u) / cell, v = (p.v - box.low.v) / cell;
      if (u >= 0 && v >= 0 && u < static_cast<double>(side) && v < static_cast<double>(side))
        set(covered[static_cast<size_t>(v) * side + static_cast<size_t>(u)]);
    }
  });
  const auto cells = static_cast<double>(std::count(covered.begin(), covered.end(), uint8_t{1}));
  return cell * std::sqrt(cells / n);
}

// Empty raster of the box with a rim of one point.
LabelRaster frame(const Extent& box, double spacing) {
  LabelRaster out;
  const double width = std::max(kLeastExtent_m, box.high.u - box.low.u) + 2 * spacing;
  const double height = std::max(kLeastExtent_m, box.high.v - box.low.v) + 2 * spacing;
  out.pixel_m =
      std::max(spacing / kPixelsPerSpacing, std::sqrt(width * height / kMaxPicturePixels));
  // Long and thin: the sides have a bound too, so that rounding up cannot pass the limit by much.
  out.pixel_m = std::max(out.pixel_m, std::max(width, height) / std::sqrt(kMaxPicturePixels) / 16);
  out.columns = static_cast<uint32_t>(width / out.pixel_m) + 1;
  out.rows = static_cast<uint32_t>(height / out.pixel_m) + 1;
  out.low = {box.low.u - spacing, box.low.v - spacing};
  out.labels.assign(size_t{out.columns} * out.rows, LabelRaster::kEmpty);
  return out;
}

// What is drawn in a pixel: the depth of its nearest point of a segment, in bits that rise with it, before the point's
// number. The least of them all is the same whatever thread comes first.
constexpr uint64_t kNothing = ~uint64_t{0};
uint64_t drawn(float depth, size_t point) {
  const auto bits = std::bit_cast<uint32_t>(depth + 0.0F);  // one zero
  constexpr uint32_t kSign = 0x80000000u;
  return uint64_t{(bits & kSign) != 0 ? ~bits : bits | kSign} << 32 | point;
}

void keep_least(uint64_t& pixel, uint64_t value) {
  std::atomic_ref<uint64_t> at(pixel);
  uint64_t least = at.load(std::memory_order_relaxed);
  while (value < least && !at.compare_exchange_weak(least, value, std::memory_order_relaxed)) {
  }
}

// Every point as a square of (2 radius + 1) pixels; the nearest one stays, noise goes where no segment is.
void draw_points(const Cloud& cloud, Labels labels, const Projection& projection, int64_t radius,
                 LabelRaster& out, Task& task) {
  std::vector<uint64_t> nearest(out.labels.size(), kNothing);
  std::vector<uint8_t> noise(out.labels.size(), 0);
  const int64_t columns = out.columns, rows = out.rows;
  const auto draw = [&](size_t i) {
    const Vec3 p = cloud.point(i);
    const Vec2 flat = projection.flat(p);
    const double u = (flat.u - out.low.u) / out.pixel_m, v = (flat.v - out.low.v) / out.pixel_m;
    if (!(u >= 0 && v >= 0 && u < static_cast<double>(columns) && v < static_cast<double>(rows)))
      return;
    const int64_t column = static_cast<int64_t>(u), row = rows - 1 - static_cast<int64_t>(v);
    const auto depth = static_cast<float>(projection.depth(p));
    if (labels[i] != 0 && !(depth < INFINITY)) return;
    const uint64_t value = drawn(depth, i);
    for (int64_t y = std::max<int64_t>(0, row - radius); y <= std::min(rows - 1, row + radius); ++y)
      for (int64_t x = std::max<int64_t>(0, column - radius);
           x <= std::min(columns - 1, column + radius); ++x) {
        const auto pixel = static_cast<size_t>(y * columns + x);
        if (labels[i] == 0) set(noise[pixel]);
        else keep_least(nearest[pixel], value);
      }
  };
  parallel_for(task, labels.size(), kPointsPerChunk, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) draw(i);
  });
  for (size_t pixel = 0; pixel < nearest.size(); ++pixel)
    if (nearest[pixel] != kNothing) out.labels[pixel] = labels[nearest[pixel] & 0xffffffffu];
    else if (noise[pixel] != 0) out.labels[pixel] = LabelRaster::kNoise;
}

// Fills pixels without a segment that lie inside one: most of their neighbours have its label.
void close_holes(LabelRaster& raster) {
  const std::vector<uint32_t> before = raster.labels;
  const size_t columns = raster.columns;
  for (size_t y = 1; y + 1 < raster.rows; ++y)
    for (size_t x = 1; x + 1 < columns; ++x) {
      const size_t at = y * columns + x;
      if (before[at] != LabelRaster::kEmpty && before[at] != LabelRaster::kNoise) continue;
      const size_t above = at - columns, below = at + columns;
      const uint32_t around[8] = {before[above - 1], before[above],    before[above + 1],
                                  before[at - 1],    before[at + 1],   before[below - 1],
                                  before[below],     before[below + 1]};
      for (const uint32_t label : around)
        if (label != LabelRaster::kEmpty &&
            std::count(around, around + 8, label) >= kClosingNeighbours)
          raster.labels[at] = label;
    }
}

}  // namespace

LabelRaster rasterise_points(const Cloud& cloud, Labels labels, const Projection& projection,
                             Task& task) {
  Extent box = extent_of(cloud, labels, projection, false, task);
  if (box.n == 0) box = extent_of(cloud, labels, projection, true, task);
  LabelRaster out;
  const bool is_shown =
      box.high.u - box.low.u <= kMostExtent_m && box.high.v - box.low.v <= kMostExtent_m;
  if (box.n == 0 || !is_shown) return out;
  const double spacing = [&] {
    ProgressSpan span(task, 0, 0.3);
    return spacing_of(cloud, projection, box, task);
  }();
  out = frame(box, spacing);
  ProgressSpan span(task, 0.3, 1);
  draw_points(cloud, labels, projection, out.pixel_m < 1.2 * spacing ? 1 : 0, out, task);
  close_holes(out);
  return out;
}

LabelRaster rasterise_labels(const Segmentation& s, PictureView view, Task& task) {
  return rasterise_points(*s.cloud, s.labels->values<uint32_t>(), projection_of(s, view, task),
                          task);
}

}  // namespace jalon
