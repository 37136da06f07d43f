// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/walls/raster.h"

#include <algorithm>
#include <cmath>

#include "modelling/plane/ring_tools.h"

namespace jalon {

namespace {

constexpr double kMostCells = 4e6;  // a 60 x 20 m facade in cells of 2 cm has 3 million
constexpr uint32_t kMargin = 2;     // cells about a hole: reveals and the wall's own border points
constexpr double kBelowNotch_m =
    1.5;  // doors go down to the ground behind a plinth before the wall
constexpr double kRasterChordOfCell = 0.1;

WallRaster empty_raster(const VectorPlane& wall, std::span<const WallHole> holes) {
  RingBox box;
  for (const VectorFace& face : wall.faces) box.add(flattened(face.outline, wall.spacing_m));
  for (const WallHole& hole : holes)
    if (hole.is_notch)
      box.add(Vec2{hole.outline.corners.front().u, hole.outline.corners.front().v - kBelowNotch_m});
  WallRaster out;
  if (wall.faces.empty()) return out;
  out.cell_m = std::max({wall.spacing_m, std::sqrt(box.width() * box.height() / kMostCells), 1e-3});
  out.origin = {box.low.u - (kMargin + 1) * out.cell_m, box.low.v - (kMargin + 1) * out.cell_m};
  out.columns = static_cast<uint32_t>(box.width() / out.cell_m) + 2 * kMargin + 4;
  out.rows = static_cast<uint32_t>(box.height() / out.cell_m) + 2 * kMargin + 4;
  return out;
}

// Cells whose centre lies in the polygon, row by row (even-odd).
void fill(WallRaster& raster, std::vector<uint32_t>& cells, std::span<const Vec2> polygon,
          uint32_t value) {
  RingBox box;
  box.add(polygon);
  const auto row_of = [&](double v) {
    return static_cast<uint32_t>(
        std::clamp((v - raster.origin.v) / raster.cell_m, 0.0, raster.rows - 1.0));
  };
  std::vector<double> crossings;
  for (uint32_t r = row_of(box.low.v); r <= row_of(box.high.v); ++r) {
    const double v = raster.centre(0, r).v;
    crossings.clear();
    for (size_t i = 0; i < polygon.size(); ++i) {
      const Vec2 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
      if ((a.v <= v) != (b.v <= v))
        crossings.push_back(a.u + (b.u - a.u) * (v - a.v) / (b.v - a.v));
    }
    std::sort(crossings.begin(), crossings.end());
    for (size_t k = 0; k + 1 < crossings.size(); k += 2) {
      const double from = std::ceil((crossings[k] - raster.origin.u) / raster.cell_m - 0.5);
      const double to = std::ceil((crossings[k + 1] - raster.origin.u) / raster.cell_m - 0.5);
      for (double c = std::max(0.0, from); c < std::min<double>(to, raster.columns); ++c)
        cells[static_cast<size_t>(r) * raster.columns + static_cast<size_t>(c)] = value;
    }
  }
}

// Each round the free neighbours of a hole's cells join it; where two holes meet the first comes first.
void grow(const WallRaster& raster, std::vector<uint32_t>& cells) {
  const std::vector<uint32_t> before = cells;
  for (uint32_t r = 1; r + 1 < raster.rows; ++r)
    for (uint32_t c = 1; c + 1 < raster.columns; ++c) {
      const size_t k = static_cast<size_t>(r) * raster.columns + c;
      if (before[k] == kNoHole)
        cells[k] = std::min(
            {before[k - 1], before[k + 1], before[k - raster.columns], before[k + raster.columns]});
    }
}

}  // namespace

WallRaster rasterise_wall(const VectorPlane& wall, std::span<const WallHole> holes) {
  WallRaster out = empty_raster(wall, holes);
  out.hole.assign(static_cast<size_t>(out.columns) * out.rows, kNoHole);
  if (out.hole.empty()) return out;
  for (size_t h = 0; h < holes.size(); ++h)
    fill(out, out.hole, flattened(holes[h].outline, kRasterChordOfCell * out.cell_m),
         static_cast<uint32_t>(h));
  out.near_hole = out.hole;
  for (size_t h = 0; h < holes.size(); ++h) {
    if (!holes[h].is_notch) continue;
    const Vec2 a = holes[h].outline.corners[0], b = holes[h].outline.corners[1];
    const double low = std::min(a.v, b.v) - kBelowNotch_m;
    const std::vector<Vec2> below{{a.u, low}, {b.u, low}, b, a};
    fill(out, out.near_hole, below, static_cast<uint32_t>(h));
  }
  for (uint32_t k = 0; k < kMargin; ++k) grow(out, out.near_hole);
  return out;
}

}  // namespace jalon
