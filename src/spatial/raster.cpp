// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "spatial/raster.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <functional>
#include <utility>

#include "base/error.h"
#include "base/text_number.h"
#include "spatial/region_runs.h"

namespace jalon {

namespace {

/// Cell number of an offset from the origin, clamped into [0, n).
uint32_t clamped_cell(double offset, double pixel_m, uint32_t n) {
  const double cell = offset / pixel_m;  // cut off below, as std::floor() of what is above 0
  if (!(cell >= 1)) return 0;
  return cell >= static_cast<double>(n) ? n - 1 : static_cast<uint32_t>(cell);
}

/// kColumnsTogether columns are swept at once: a cache line of each row.
constexpr size_t kColumnsTogether = 64;

/// own = own op other, byte by byte; other lies ahead of own and may overlap it, which keeps compilers from doing many
/// bytes at once.
template <class Op>
void join_ahead(uint8_t* own, const uint8_t* other, size_t n, Op op) {
  using Words = std::array<uint64_t, 4>;
  size_t i = 0;
  for (; i + sizeof(Words) <= n; i += sizeof(Words)) {
    Words a, b;
    std::memcpy(a.data(), own + i, sizeof a);
    std::memcpy(b.data(), other + i, sizeof b);
    for (size_t k = 0; k < a.size(); ++k) a[k] = op(a[k], b[k]);
    std::memcpy(own + i, a.data(), sizeof a);
  }
  for (; i < n; ++i) own[i] = static_cast<uint8_t>(op(own[i], other[i]));
}

/// Each of the first n places of a line, `wide` bytes of 0 or 1 each, becomes the greatest (grow) or the least of the
/// `window` places from it on: over 2, 4, 8 ... places from two of half as many, the last two overlapping.
void sweep_line(uint8_t* line, size_t n, size_t window, size_t wide, bool grow) {
  const auto join = [&](size_t places, size_t apart) {
    uint8_t* other = line + apart * wide;
    if (grow) join_ahead(line, other, places * wide, std::bit_or<uint64_t>());
    else join_ahead(line, other, places * wide, std::bit_and<uint64_t>());
  };
  size_t have = 1, places = n + window - 1;
  for (; 2 * have <= window; have *= 2) join(places -= have, have);
  if (have < window) join(n, window - have);
}

/// Sliding maximum (grow) or minimum along a row, in place; beyond its ends everything is empty.
void sweep_row(uint8_t* row, size_t n, uint32_t radius, bool grow, std::vector<uint8_t>& line) {
  line.assign(n + 2 * size_t{radius}, 0);
  std::copy_n(row, n, line.data() + radius);
  sweep_line(line.data(), n, 2 * size_t{radius} + 1, 1, grow);
  std::copy_n(line.data(), n, row);
}

/// The same along some columns at once, as they lie in memory.
void sweep_columns(uint8_t* pixels, size_t columns, size_t rows, size_t wide, uint32_t radius,
                   bool grow, std::vector<uint8_t>& line) {
  line.assign((rows + 2 * size_t{radius}) * wide, 0);
  for (size_t row = 0; row < rows; ++row)
    std::copy_n(pixels + row * columns, wide, line.data() + (row + radius) * wide);
  sweep_line(line.data(), rows, 2 * size_t{radius} + 1, wide, grow);
  for (size_t row = 0; row < rows; ++row)
    std::copy_n(line.data() + row * wide, wide, pixels + row * columns);
}

/// A window that reaches beyond the whole image sees no more than one that ends there.
uint32_t useful_radius(const Raster& raster, uint32_t radius) {
  return std::min(radius, std::max(raster.columns, raster.rows));
}

Raster swept(const Raster& raster, uint32_t radius, bool grow) {
  Raster out = raster;
  if (radius == 0 || raster.pixels.empty()) return out;
  radius = useful_radius(raster, radius);
  for (uint8_t& pixel : out.pixels) pixel = pixel != 0;
  std::vector<uint8_t> line;
  for (size_t row = 0; row < raster.rows; ++row)
    sweep_row(out.pixels.data() + row * raster.columns, raster.columns, radius, grow, line);
  for (size_t column = 0; column < raster.columns; column += kColumnsTogether)
    sweep_columns(out.pixels.data() + column, raster.columns, raster.rows,
                  std::min(kColumnsTogether, raster.columns - column), radius, grow, line);
  return out;
}

}  // namespace

size_t Raster::pixel_of(const Vec2& p) const {
  return size_t{clamped_cell(p.v - origin.v, pixel_m, rows)} * columns +
         clamped_cell(p.u - origin.u, pixel_m, columns);
}

bool Raster::holds(const Vec2& p) const {
  const double column = (p.u - origin.u) / pixel_m, row = (p.v - origin.v) / pixel_m;
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
  RegionRuns found = region_runs(raster, connectivity);
  Regions regions;
  regions.labels.assign(raster.pixels.size(), 0);
  for (const RegionRuns::Run& run : found.runs)
    std::fill_n(regions.labels.begin() + run.begin, run.end - run.begin, run.label);
  regions.pixel_counts = std::move(found.pixel_counts);
  return regions;
}

Raster dilated(const Raster& raster, uint32_t radius) { return swept(raster, radius, true); }
Raster eroded(const Raster& raster, uint32_t radius) { return swept(raster, radius, false); }

}  // namespace jalon
