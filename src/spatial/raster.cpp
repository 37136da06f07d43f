// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "spatial/raster.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/text_number.h"
#include "spatial/union_find.h"

namespace jalon {

namespace {

/// Cell number of an offset from the origin, clamped into [0, n).
uint32_t clamped_cell(double offset, double pixel_m, uint32_t n) {
  const double cell = std::floor(offset / pixel_m);
  if (!(cell > 0)) return 0;
  return cell >= static_cast<double>(n) ? n - 1 : static_cast<uint32_t>(cell);
}

/// Sliding maximum (grow) or minimum along a row of the image by counting the set pixels in the window.
void sweep_row(const uint8_t* in, uint8_t* out, size_t n, uint32_t radius, bool grow) {
  const size_t window = 2 * size_t{radius} + 1;
  size_t set = 0;
  for (size_t i = 0; i < std::min<size_t>(radius, n); ++i) set += in[i] != 0;
  for (size_t i = 0; i < n; ++i) {
    if (i + radius < n) set += in[i + radius] != 0;
    if (i > radius) set -= in[i - radius - 1] != 0;
    out[i] = grow ? set != 0 : set == window;
  }
}

/// The same along all columns at once, row by row, as they lie in memory.
void sweep_columns(const uint8_t* in, uint8_t* out, size_t columns, size_t rows, uint32_t radius,
                   bool grow) {
  const uint32_t window = 2 * radius + 1;
  std::vector<uint32_t> set(columns, 0);
  const auto enter = [&](size_t row) {
    for (size_t c = 0; c < columns; ++c) set[c] += in[row * columns + c] != 0;
  };
  for (size_t row = 0; row < std::min<size_t>(radius, rows); ++row) enter(row);
  for (size_t row = 0; row < rows; ++row) {
    if (row + radius < rows) enter(row + radius);
    if (row > radius)
      for (size_t c = 0; c < columns; ++c) set[c] -= in[(row - radius - 1) * columns + c] != 0;
    for (size_t c = 0; c < columns; ++c)
      out[row * columns + c] = grow ? set[c] != 0 : set[c] == window;
  }
}

Raster swept(const Raster& raster, uint32_t radius, bool grow) {
  Raster out = raster;
  if (radius == 0 || raster.pixels.empty()) return out;
  std::vector<uint8_t> half(raster.pixels.size());
  for (size_t row = 0; row < raster.rows; ++row)
    sweep_row(raster.pixels.data() + row * raster.columns, half.data() + row * raster.columns,
              raster.columns, radius, grow);
  sweep_columns(half.data(), out.pixels.data(), raster.columns, raster.rows, radius, grow);
  return out;
}

/// First pass: each occupied pixel joins its occupied neighbours that come before it in row order.
void join_neighbours(const Raster& raster, bool diagonal, UnionFind& sets) {
  const size_t columns = raster.columns;
  const uint8_t* pixel = raster.pixels.data();
  for (size_t row = 0; row < raster.rows; ++row)
    for (size_t column = 0; column < columns; ++column) {
      const size_t i = row * columns + column;
      if (pixel[i] == 0) continue;
      const auto join = [&](size_t j) {
        if (pixel[j] != 0) sets.join(static_cast<uint32_t>(i), static_cast<uint32_t>(j));
      };
      if (column > 0) join(i - 1);
      if (row == 0) continue;
      join(i - columns);
      if (!diagonal) continue;
      if (column > 0) join(i - columns - 1);
      if (column + 1 < columns) join(i - columns + 1);
    }
}

}  // namespace

size_t Raster::pixel_of(const Vec2& p) const {
  return size_t{clamped_cell(p.v - origin.v, pixel_m, rows)} * columns +
         clamped_cell(p.u - origin.u, pixel_m, columns);
}

bool Raster::holds(const Vec2& p) const {
  const double column = std::floor((p.u - origin.u) / pixel_m),
               row = std::floor((p.v - origin.v) / pixel_m);
  return column >= 0 && row >= 0 && column < columns && row < rows &&
         pixels[static_cast<size_t>(row) * columns + static_cast<size_t>(column)] != 0;
}

Raster rasterise(std::span<const Vec2> points, double pixel_m, uint32_t margin) {
  if (!(pixel_m > 0) || !std::isfinite(pixel_m))
    fail(Status::kInvalidArgument, "a pixel of %s m: it must be above 0", text_of(pixel_m).c_str());
  Raster raster;
  raster.pixel_m = pixel_m;
  if (points.empty()) return raster;
  Vec2 low = points[0], high = points[0];
  for (const Vec2& p : points) {
    low = {std::min(low.u, p.u), std::min(low.v, p.v)};
    high = {std::max(high.u, p.u), std::max(high.v, p.v)};
  }
  const double columns = std::floor((high.u - low.u) / pixel_m) + 1 + 2.0 * margin;
  const double rows = std::floor((high.v - low.v) / pixel_m) + 1 + 2.0 * margin;
  if (!(columns * rows <= static_cast<double>(kMaxRasterPixels)))
    fail(Status::kLimit, "pixels of %s m make an image of %s x %s; take larger ones",
         text_of(pixel_m).c_str(), text_of(columns).c_str(), text_of(rows).c_str());
  raster.columns = static_cast<uint32_t>(columns);
  raster.rows = static_cast<uint32_t>(rows);
  raster.origin = {low.u - margin * pixel_m, low.v - margin * pixel_m};
  raster.pixels.assign(size_t{raster.columns} * raster.rows, 0);
  for (const Vec2& p : points) {
    // Relative to the lowest corner, so that the margin cannot change which pixel a point falls into.
    const size_t column =
        clamped_cell(p.u - low.u, pixel_m, raster.columns - 2 * margin) + size_t{margin};
    const size_t row =
        clamped_cell(p.v - low.v, pixel_m, raster.rows - 2 * margin) + size_t{margin};
    raster.pixels[row * raster.columns + column] = 1;
  }
  return raster;
}

Regions label_regions(const Raster& raster, Connectivity2 connectivity) {
  UnionFind sets(raster.pixels.size());
  join_neighbours(raster, connectivity == Connectivity2::k8, sets);
  Regions regions;
  regions.labels.assign(raster.pixels.size(), 0);
  // Second pass: provisional numbers in order of the first pixel, then by falling size.
  std::vector<uint64_t> sizes;
  constexpr uint32_t kNone = 0xffffffffu;
  std::vector<uint32_t> number(raster.pixels.size(), kNone);
  for (size_t i = 0; i < raster.pixels.size(); ++i) {
    if (raster.pixels[i] == 0) continue;
    uint32_t& own = number[sets.find(static_cast<uint32_t>(i))];
    if (own == kNone) {
      own = static_cast<uint32_t>(sizes.size());
      sizes.push_back(0);
    }
    ++sizes[own];
    regions.labels[i] = own + 1;
  }
  const std::vector<uint32_t> rank = ranks_by_size(sizes);
  regions.pixel_counts.assign(sizes.size() + 1, 0);
  for (size_t i = 0; i < raster.pixels.size(); ++i) {
    if (regions.labels[i] != 0) regions.labels[i] = rank[regions.labels[i] - 1];
    ++regions.pixel_counts[regions.labels[i]];
  }
  return regions;
}

Raster dilated(const Raster& raster, uint32_t radius) { return swept(raster, radius, true); }
Raster eroded(const Raster& raster, uint32_t radius) { return swept(raster, radius, false); }

}  // namespace jalon
