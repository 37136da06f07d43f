// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/contour/band.h"

#include <algorithm>
#include <cmath>

#include "base/serial.h"
#include "geometry/delaunay2.h"
#include "modelling/plane/cell_rows.h"

namespace jalon {

namespace {

// Local spacings count from 0.7 to 2 times the typical one: scattered points vary by so much among 25 cells, and a few
// stray points must not join far things.
constexpr double kLeastLocal = 0.7, kMostLocal = 2;
// Two rows of points have a standard deviation of half a spacing across them.
constexpr double kStringOfSpacing = 0.3;
constexpr size_t kBandCellsPerLook = 1 << 13;
constexpr size_t kTrianglesPerBandLook = size_t{1} << 17;

// Spacing about a cell: the occupied ones of the 5 x 5 cells around it.
float spacing_about(const CellRows& rows, size_t cell) {
  const uint64_t row = rows.keys[cell] >> 32, column = rows.keys[cell] & 0xffffffffu;
  uint64_t cells = 0, points = 0;
  for (uint64_t r = row > 2 ? row - 2 : 0; r <= row + 2; ++r) {
    const uint64_t from = r << 32 | (column > 2 ? column - 2 : 0), to = r << 32 | (column + 2);
    auto c = static_cast<size_t>(std::lower_bound(rows.keys.begin(), rows.keys.end(), from) -
                                 rows.keys.begin());
    for (; c < rows.keys.size() && rows.keys[c] <= to; ++c) {
      ++cells;
      points += rows.first[c + 1] - rows.first[c];
    }
  }
  return static_cast<float>(rows.cell_m *
                            std::sqrt(static_cast<double>(cells) / static_cast<double>(points)));
}

// Sums over the points of a cell, about a place near them.
struct CellMoments {
  double n = 0, u = 0, v = 0, uu = 0, uv = 0, vv = 0;
  void add(const Vec2& d) {
    n += 1;
    u += d.u, v += d.v;
    uu += d.u * d.u, uv += d.u * d.v, vv += d.v * d.v;
  }
  void add(const CellMoments& o) {
    n += o.n, u += o.u, v += o.v;
    uu += o.uu, uv += o.uv, vv += o.vv;
  }
  /// Standard deviation across the line that fits best.
  double thickness() const {
    const double a = uu / n - u * u / (n * n), b = uv / n - u * v / (n * n),
                 c = vv / n - v * v / (n * n);
    const double least = (a + c) / 2 - std::hypot((a - c) / 2, b);
    return std::sqrt(std::max(0.0, least));
  }
};

// Cells whose points, with those of the cells around them, lie in a line: where another surface crosses the plane it
// leaves a string of its points there, and a string bounds nothing; no more does a point far from all others.
std::vector<uint8_t> strings_of(const CellRows& rows, std::span<const Vec2> points,
                                std::span<const uint8_t> deep, double spacing_m, Task& task) {
  std::vector<CellMoments> moments(rows.keys.size());
  serial_for(task, rows.keys.size(), kBandCellsPerLook, [&](size_t begin, size_t end) {
    for (size_t c = begin; c < end; ++c)
      for (uint32_t k = rows.first[c]; k < rows.first[c + 1]; ++k)
        moments[c].add(points[rows.order[k]] - rows.corner);
  });
  std::vector<uint8_t> out(rows.keys.size(), 0);
  for (size_t c = 0; c < rows.keys.size(); ++c) {
    if (c % kBandCellsPerLook == 0) task.checkpoint(0);
    if (deep[c] != 0) continue;
    const uint64_t row = rows.keys[c] >> 32, column = rows.keys[c] & 0xffffffffu;
    CellMoments sum;
    for (uint64_t r = row > 1 ? row - 1 : 0; r <= row + 1; ++r) {
      const uint64_t from = r << 32 | (column > 1 ? column - 1 : 0), to = r << 32 | (column + 1);
      auto i = static_cast<size_t>(std::lower_bound(rows.keys.begin(), rows.keys.end(), from) -
                                   rows.keys.begin());
      for (; i < rows.keys.size() && rows.keys[i] <= to; ++i) sum.add(moments[i]);
    }
    out[c] = sum.thickness() < kStringOfSpacing * spacing_m;
  }
  return out;
}

bool is_inner(const ContourBand& band, const Triangle2& t) {
  return band.is_inner[t[0]] && band.is_inner[t[1]] && band.is_inner[t[2]];
}

double squared(const Vec2& d) { return dot(d, d); }

}  // namespace

ContourBand contour_band(std::span<const Vec2> points, double cell_m, double spacing_m,
                         const std::function<bool(uint32_t)>& foreign, Task& task) {
  const CellRows rows = sort_into_cells(points, cell_m, task);
  const std::vector<uint8_t> occupied(rows.keys.size(), 1);
  const auto inner = eroded(rows, occupied), deep = eroded(rows, inner);
  const auto strings = strings_of(rows, points, deep, spacing_m, task);
  ContourBand band;
  for (size_t c = 0; c < rows.keys.size(); ++c) {
    if (c % kBandCellsPerLook == 0) task.checkpoint(0);
    if (deep[c] != 0 || strings[c] != 0) continue;
    const float spacing = spacing_about(rows, c);
    for (uint32_t k = rows.first[c]; k < rows.first[c + 1]; ++k) {
      if (foreign && foreign(rows.order[k])) continue;
      band.points.push_back(points[rows.order[k]]);
      band.is_inner.push_back(inner[c]);
      band.spacing_m.push_back(spacing);
    }
  }
  return band;
}

std::vector<Triangle2> all_triangles(const ContourBand& band, Task& task) {
  double low = INFINITY, high = -INFINITY;
  for (const Vec2& p : band.points) {
    low = std::min({low, p.u, p.v});
    high = std::max({high, p.u, p.v});
  }
  constexpr double kMaxSteps = 0x1p29;  // half of what delaunay() takes
  return delaunay(band.points, std::max(kDelaunayGrid_m, (high - low) / kMaxSteps), &task);
}

std::vector<Triangle2> short_triangles(const ContourBand& band, double max_edge_m, Task& task) {
  auto triangles = all_triangles(band, task);
  const double limit = max_edge_m * max_edge_m;
  const auto is_long = [&](uint32_t a, uint32_t b) {
    return squared(band.points[a] - band.points[b]) > limit;
  };
  size_t seen = 0;
  std::erase_if(triangles, [&](const Triangle2& t) {
    if (seen++ % kTrianglesPerBandLook == 0) task.checkpoint(0);
    return !is_inner(band, t) &&
           (is_long(t[0], t[1]) || is_long(t[1], t[2]) || is_long(t[2], t[0]));
  });
  return triangles;
}

std::vector<Triangle2> alpha_triangles(const ContourBand& band, double radius_m, double typical_m,
                                       Task& task) {
  auto triangles = all_triangles(band, task);
  const auto limit_of = [&](const Triangle2& t) {
    if (typical_m == 0) return radius_m;
    const double local =
        std::max({band.spacing_m[t[0]], band.spacing_m[t[1]], band.spacing_m[t[2]]});
    return radius_m * std::clamp(local / typical_m, kLeastLocal, kMostLocal);
  };
  size_t seen = 0;
  std::erase_if(triangles, [&](const Triangle2& t) {
    if (seen++ % kTrianglesPerBandLook == 0) task.checkpoint(0);
    if (is_inner(band, t)) return false;
    const Vec2 a = band.points[t[1]] - band.points[t[0]], b = band.points[t[2]] - band.points[t[1]],
               c = band.points[t[0]] - band.points[t[2]];
    // Circumradius = product of the edges / (4 area).
    const double limit = limit_of(t), four_area = 2 * cross(a, b);
    return squared(a) * squared(b) * squared(c) > limit * limit * four_area * four_area;
  });
  return triangles;
}

}  // namespace jalon
