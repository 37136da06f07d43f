// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/contour/contour.h"

#include <algorithm>
#include <cmath>
#include <unordered_set>
#include <utility>

#include "base/error.h"
#include "geometry/polygon2.h"
#include "modelling/contour/band.h"
#include "modelling/contour/boundary_rings.h"
#include "modelling/contour/long_edges.h"
#include "modelling/plane/spacing.h"

namespace jalon {

namespace {

// Steps 3 of both modes: widest gap that is still surface where the spacing is typical.
double widest_gap(std::span<const Vec2> points, double spacing_m, const ContourSetting& setting,
                  Task& task) {
  if (setting.max_edge_m > 0) return setting.max_edge_m;
  if (setting.mode == ContourMode::kAlpha)
    return 2 * setting.alpha_factor * spacing_m;  // a circle's diameter
  const ContourBand band = contour_band(points, kMostSpacings * spacing_m / 2, spacing_m, {}, task);
  return long_edge_threshold(edge_lengths(band.points, all_triangles(band, task)), spacing_m);
}

constexpr double kApartSpacings = 0.01;  // far below what a contour point is worth

// A corner of an opening, away from its surface: the opening lies to the right of the walk.
Vec2 moved_into_opening(const Chain& chain, size_t i, double by_m) {
  const size_t n = chain.size();
  const Vec2 in = chain[i] - chain[(i + n - 1) % n], out = chain[(i + 1) % n] - chain[i];
  const Vec2 along = in * (1 / norm(in)) + out * (1 / norm(out));
  const Vec2 right{along.v, -along.u};
  return norm(right) > 0 ? chain[i] + right * (by_m / norm(right))
                         : chain[i] + in * (-by_m / norm(in));
}

// Rings of a piece may touch in a point; faces are sound only where they do not. `taken`: points of the rings before.
void keep_apart(const std::vector<uint32_t>& ring, double by_m, std::unordered_set<uint32_t>& taken,
                Chain& opening) {
  const Chain before = opening;
  for (size_t i = 0; i < ring.size(); ++i)
    if (!taken.insert(ring[i]).second) opening[i] = moved_into_opening(before, i, by_m);
}

// Step 5: rings of one piece become its outline and the openings that are large enough.
ContourPiece make_piece(const BoundaryPiece& rings, std::span<const Vec2> points,
                        const ContourSetting& setting, double spacing_m) {
  ContourPiece piece;
  piece.area_m2 = rings.area;
  const std::vector<uint32_t>* outline = nullptr;
  double outline_area = 0;
  std::vector<std::pair<const std::vector<uint32_t>*, Chain>> openings;
  for (const auto& ring : rings.rings) {
    Chain chain;
    chain.reserve(ring.size());
    for (const uint32_t i : ring) chain.push_back(points[i]);
    const double area = signed_area(chain);
    if (area > outline_area) {
      outline_area = area;
      outline = &ring;
      piece.outline = std::move(chain);
    } else if (area < 0 && -area >= setting.min_opening_area_m2 &&
               equivalent_width(-area, perimeter(chain)) >= setting.min_opening_width_m) {
      openings.emplace_back(&ring, std::move(chain));
    }
  }
  if (outline == nullptr) return piece;
  std::unordered_set<uint32_t> taken(outline->begin(), outline->end());
  for (auto& [ring, chain] : openings) {
    keep_apart(*ring, kApartSpacings * spacing_m, taken, chain);
    piece.openings.push_back(std::move(chain));
  }
  return piece;
}

}  // namespace

double equivalent_width(double area_m2, double perimeter_m) {
  const double quarter = perimeter_m / 4, discriminant = quarter * quarter - area_m2;
  return discriminant > 0 ? quarter - std::sqrt(discriminant) : std::sqrt(area_m2);
}

Contour extract_contour(std::span<const Vec2> points, const ContourSetting& setting, Task& task,
                        const ForeignTest& foreign) {
  Contour out;
  if (points.size() < 3) return out;
  // 1. Spacing and the widest gap that still joins neighbours.
  out.spacing_m = typical_spacing(points, task);
  const double typical_m = stepped_length(out.spacing_m);
  out.max_edge_m = widest_gap(points, typical_m, setting, task);
  if (!(out.max_edge_m > 0)) return out;
  if (out.spacing_m == 0) out.spacing_m = out.max_edge_m / (2 * setting.alpha_factor);
  task.checkpoint(0);
  // 2. Points near a contour: cells of half a gap, so that neighbours in the plane are neighbours in the raster.
  std::function<bool(uint32_t)> is_foreign;
  if (foreign)
    is_foreign = [&](uint32_t point) {
      // The points around one may be most of the cloud.
      if (task.cancelled()) fail(Status::kCancelled, "cancelled");
      return foreign(point, out.spacing_m);
    };
  const ContourBand band =
      contour_band(points, out.max_edge_m / 2, out.spacing_m, is_foreign, task);
  if (band.points.empty()) return out;
  task.checkpoint(0);
  // 3. Triangles that span no gap.
  const bool is_local = setting.max_edge_m == 0;
  const auto triangles =
      setting.mode == ContourMode::kAlpha
          ? alpha_triangles(band, out.max_edge_m / 2, is_local ? typical_m : 0, task)
          : short_triangles(band, out.max_edge_m, task);
  task.checkpoint(0);
  // 4. Their borders as rings, piece by piece.  5. Outline and openings.
  for (const auto& rings : boundary_rings(triangles, band.points, task))
    if (rings.area >= setting.min_area_m2)
      out.pieces.push_back(make_piece(rings, band.points, setting, out.spacing_m));
  std::erase_if(out.pieces, [](const ContourPiece& piece) { return piece.outline.size() < 3; });
  std::stable_sort(
      out.pieces.begin(), out.pieces.end(),
      [](const ContourPiece& a, const ContourPiece& b) { return a.area_m2 > b.area_m2; });
  return out;
}

}  // namespace jalon
