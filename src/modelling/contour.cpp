// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/contour.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "geometry/delaunay2.h"
#include "geometry/polygon2.h"
#include "modelling/boundary_rings.h"
#include "modelling/cell_rows.h"

namespace jalon {

namespace {

constexpr size_t kSamples = 1000;
constexpr size_t kNeighbours = 8;
constexpr double kSpacingQuantile = 0.75;
// k points in a disc of radius d take pi d^2 / k each: spacing = sqrt(pi / 8) d.
const double kSpacingOfRadius = std::sqrt(3.14159265358979323846 / static_cast<double>(kNeighbours));

// Squared distance to the 8th neighbour of p, looking at most reach cells away; infinity when there are fewer.
double eighth_neighbour(std::span<const Vec2> points, const CellRows& rows, const Vec2& p, uint64_t reach) {
  std::array<double, kNeighbours + 1> best;  // p itself is among them
  best.fill(INFINITY);
  const uint64_t key = rows.key_of(p), row = key >> 32, column = key & 0xffffffffu;
  for (uint64_t r = row > reach ? row - reach : 0; r <= row + reach; ++r) {
    const uint64_t from = r << 32 | (column > reach ? column - reach : 0), to = r << 32 | (column + reach);
    auto cell = static_cast<size_t>(std::lower_bound(rows.keys.begin(), rows.keys.end(), from) - rows.keys.begin());
    for (; cell < rows.keys.size() && rows.keys[cell] <= to; ++cell)
      for (uint32_t k = rows.first[cell]; k < rows.first[cell + 1]; ++k) {
        const Vec2 d = points[rows.order[k]] - p;
        const double squared = dot(d, d);
        if (squared >= best.back()) continue;
        *std::prev(best.end()) = squared;
        for (size_t i = best.size() - 1; i > 0 && best[i] < best[i - 1]; --i) std::swap(best[i], best[i - 1]);
      }
  }
  return best.back();
}

// Step 2: points that can lie on a contour, and whether they lie in an inner cell (all its neighbours occupied).
struct Band {
  std::vector<Vec2> points;
  std::vector<uint8_t> is_inner;
};

Band contour_band(std::span<const Vec2> points, double cell_m) {
  const CellRows rows = sort_into_cells(points, cell_m);
  const std::vector<uint8_t> occupied(rows.keys.size(), 1);
  const auto inner = eroded(rows, occupied), deep = eroded(rows, inner);
  Band band;
  for (size_t c = 0; c < rows.keys.size(); ++c) {
    if (deep[c] != 0) continue;
    for (uint32_t k = rows.first[c]; k < rows.first[c + 1]; ++k) {
      band.points.push_back(points[rows.order[k]]);
      band.is_inner.push_back(inner[c]);
    }
  }
  return band;
}

// Step 3: no edge above the limit. Triangles among inner cells stay whatever their size: they span the points left out.
std::vector<Triangle2> short_triangles(const Band& band, double max_edge_m) {
  double low = INFINITY, high = -INFINITY;
  for (const Vec2& p : band.points) {
    low = std::min({low, p.u, p.v});
    high = std::max({high, p.u, p.v});
  }
  constexpr double kMaxSteps = 0x1p29;  // half of what delaunay() takes
  auto triangles = delaunay(band.points, std::max(kDelaunayGrid_m, (high - low) / kMaxSteps));
  const double limit = max_edge_m * max_edge_m;
  const auto is_long = [&](uint32_t a, uint32_t b) {
    const Vec2 d = band.points[a] - band.points[b];
    return dot(d, d) > limit;
  };
  std::erase_if(triangles, [&](const Triangle2& t) {
    if (band.is_inner[t[0]] && band.is_inner[t[1]] && band.is_inner[t[2]]) return false;
    return is_long(t[0], t[1]) || is_long(t[1], t[2]) || is_long(t[2], t[0]);
  });
  return triangles;
}

// Step 5: rings of one piece become its outline and the openings that are large enough.
ContourPiece make_piece(const BoundaryPiece& rings, std::span<const Vec2> points, const ContourSetting& setting) {
  ContourPiece piece;
  piece.area_m2 = rings.area;
  double outline_area = 0;
  for (const auto& ring : rings.rings) {
    Chain chain;
    chain.reserve(ring.size());
    for (const uint32_t i : ring) chain.push_back(points[i]);
    const double area = signed_area(chain);
    if (area > outline_area) {
      outline_area = area;
      piece.outline = std::move(chain);
    } else if (area < 0 && -area >= setting.min_opening_area_m2 &&
               equivalent_width(-area, perimeter(chain)) >= setting.min_opening_width_m) {
      piece.openings.push_back(std::move(chain));
    }
  }
  return piece;
}

}  // namespace

double equivalent_width(double area_m2, double perimeter_m) {
  const double quarter = perimeter_m / 4, discriminant = quarter * quarter - area_m2;
  return discriminant > 0 ? quarter - std::sqrt(discriminant) : std::sqrt(area_m2);
}

double typical_spacing(std::span<const Vec2> points, Task& task) {
  if (points.size() <= kNeighbours) return 0;
  Vec2 low = points.front(), high = points.front();
  for (const Vec2& p : points) {
    low = {std::min(low.u, p.u), std::min(low.v, p.v)};
    high = {std::max(high.u, p.u), std::max(high.v, p.v)};
  }
  const double n = static_cast<double>(points.size());
  const double du = high.u - low.u, dv = high.v - low.v;
  // Cells of about four points if the points filled their box; a narrow or sparse segment has fuller cells.
  const double cell = std::max(2 * std::sqrt(du * dv / n), 2 * std::max(du, dv) / n);
  if (!(cell > 0)) return 0;
  const CellRows rows = sort_into_cells(points, cell);
  const size_t step = (points.size() + kSamples - 1) / kSamples;
  std::vector<double> spacings;
  for (size_t i = 0; i < points.size(); i += step) {
    if (spacings.size() % 64 == 0) task.checkpoint(0);
    double squared = INFINITY;
    for (uint64_t reach = 1; reach <= 16 && !std::isfinite(squared); reach *= 4) {
      squared = eighth_neighbour(points, rows, points[i], reach);
      const double safe = static_cast<double>(reach) * rows.cell_m;  // nothing nearer lies beyond the cells looked at
      if (squared > safe * safe) squared = INFINITY;
    }
    if (std::isfinite(squared)) spacings.push_back(kSpacingOfRadius * std::sqrt(squared));
  }
  if (spacings.empty()) return 0;
  const auto at = spacings.begin() +
      static_cast<ptrdiff_t>(kSpacingQuantile * static_cast<double>(spacings.size() - 1));
  std::nth_element(spacings.begin(), at, spacings.end());
  return *at;
}

Contour extract_contour(std::span<const Vec2> points, const ContourSetting& setting, Task& task) {
  Contour out;
  if (points.size() < 3) return out;
  // 1. Spacing and the longest edge that still joins neighbours.
  out.spacing_m = typical_spacing(points, task);
  out.max_edge_m = setting.max_edge_m > 0 ? setting.max_edge_m : setting.edge_factor * out.spacing_m;
  if (!(out.max_edge_m > 0)) return out;
  if (out.spacing_m == 0) out.spacing_m = out.max_edge_m / setting.edge_factor;
  task.checkpoint(0);
  // 2. Points near a contour: cells of half an edge, so that neighbours in the plane are neighbours in the raster.
  const Band band = contour_band(points, out.max_edge_m / 2);
  task.checkpoint(0);
  // 3. Triangles without long edges.
  const auto triangles = short_triangles(band, out.max_edge_m);
  task.checkpoint(0);
  // 4. Their borders as rings, piece by piece.  5. Outline and openings.
  for (const auto& rings : boundary_rings(triangles, band.points))
    if (rings.area >= setting.min_area_m2) out.pieces.push_back(make_piece(rings, band.points, setting));
  std::erase_if(out.pieces, [](const ContourPiece& piece) { return piece.outline.size() < 3; });
  std::stable_sort(out.pieces.begin(), out.pieces.end(),
                   [](const ContourPiece& a, const ContourPiece& b) { return a.area_m2 > b.area_m2; });
  return out;
}

}  // namespace jalon
