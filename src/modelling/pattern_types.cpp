// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/pattern_types.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "geometry/polygon2.h"
#include "modelling/patterns.h"

namespace jalon {

namespace {

constexpr double kChord_m = 5e-4;       // of arcs: far below any spacing
constexpr double kEdgeSigma = 0.3;      // of the spacing, for edges that tell none (the accuracy asked of vertices)
constexpr double kSigmas = 3;           // of the difference of two sizes
constexpr double kForm = 0.04;          // share of the box that the form fills: a round head costs 0.05-0.1 of it
constexpr double kResidual = 0.5;       // of the spacing: border points scatter by so much about a true edge

/// What sets one opening beside another.
struct Size {
  double width_m, height_m, fill, sigma_m;
};

Size size_of(const FacadeOpening& opening, double spacing_m) {
  const std::vector<Vec2> points = outline_points(opening.outline);
  const RingBox box = ring_box(opening.outline);
  double variance = 0;
  for (const VectorEdge& e : opening.outline.edges)
    variance = std::max(variance, std::isfinite(e.sigma_m) ? e.sigma_m * e.sigma_m
                                                           : std::pow(kEdgeSigma * spacing_m, 2));
  const double area = box.width() * box.height();
  return {box.width(), box.height(), area > 0 ? signed_area(points) / area : 0, std::sqrt(2 * variance)};
}

bool is_like(const Size& a, const Size& b, double tolerance_m) {
  const double tolerance = std::max(tolerance_m, kSigmas * std::hypot(a.sigma_m, b.sigma_m));
  return std::fabs(a.width_m - b.width_m) <= tolerance && std::fabs(a.height_m - b.height_m) <= tolerance &&
         std::fabs(a.fill - b.fill) <= kForm;
}

}  // namespace

std::vector<Vec2> outline_points(const VectorRing& ring) { return flattened(ring, kChord_m); }

bool is_well_measured(const FacadeOpening& opening, const FacadeWall& wall, const PatternSetting& setting) {
  const bool is_known = opening.evidence != Evidence::kNone && opening.evidence != Evidence::kCopied;
  return is_known && opening.outline.corners.size() >= 3 && opening.coverage >= setting.least_coverage &&
         !(opening.residual_m > std::max(kResidual * wall.spacing_m, 2 * wall.sigma_m));
}

std::vector<Pattern> find_patterns(const FacadeWall& wall, const PatternSetting& setting) {
  // 1. The best measured first: most of the outline seen, then the least residual, then the order on the wall.
  std::vector<size_t> order;
  for (size_t i = 0; i < wall.openings.size(); ++i)
    if (is_well_measured(wall.openings[i], wall, setting)) order.push_back(i);
  const auto residual = [&](size_t i) {
    const double r = wall.openings[i].residual_m;
    return std::isfinite(r) ? r : wall.spacing_m;
  };
  std::sort(order.begin(), order.end(), [&](size_t a, size_t b) {
    if (wall.openings[a].coverage != wall.openings[b].coverage)
      return wall.openings[a].coverage > wall.openings[b].coverage;
    return residual(a) != residual(b) ? residual(a) < residual(b) : a < b;
  });

  // 2. Each joins the first pattern whose best one it is like.
  std::vector<Pattern> out;
  std::vector<Size> sizes;
  for (const size_t i : order) {
    const Size size = size_of(wall.openings[i], wall.spacing_m);
    size_t p = 0;
    while (p < out.size() && !(wall.openings[out[p].best].kind == wall.openings[i].kind &&
                               is_like(sizes[p], size, setting.size_tolerance_m)))
      ++p;
    if (p == out.size()) {
      out.push_back({i, {}, ring_box(wall.openings[i].outline)});
      sizes.push_back(size);
    }
    out[p].members.push_back(i);
  }
  for (Pattern& p : out) std::sort(p.members.begin(), p.members.end());
  return out;
}

}  // namespace jalon
