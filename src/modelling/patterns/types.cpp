// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/patterns/types.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "geometry/polygon2.h"
#include "modelling/patterns/patterns.h"

namespace jalon {

namespace {

constexpr double kChord_m = 5e-4;  // of arcs: far below any spacing
constexpr double kEdgeSigma =
    0.3;  // of the spacing, for edges that tell none (the accuracy asked of vertices)
constexpr double kSigmas = 3;  // of the difference of two sizes
constexpr double kForm = 2;  // tolerances of size by which outlines of one form may differ anywhere
constexpr double kResidual =
    0.75;  // of the spacing: about a true edge border points scatter by 0.3-0.55

/// What sets one opening beside another.
struct Size {
  RingBox box;
  std::vector<Vec2> outline;
  double sigma_m;
};

Size size_of(const FacadeOpening& opening, double spacing_m) {
  double variance = 0;
  for (const VectorEdge& e : opening.outline.edges)
    variance = std::max(variance, std::isfinite(e.sigma_m) ? e.sigma_m * e.sigma_m
                                                           : std::pow(kEdgeSigma * spacing_m, 2));
  return {ring_box(opening.outline), outline_points(opening.outline), std::sqrt(2 * variance)};
}

/// Farthest that a corner of one outline lies from the other, their boxes' middles on each other.
double difference(const Size& a, const Size& b) {
  const Vec2 shift = a.box.middle() - b.box.middle();
  double worst = 0;
  for (const Vec2& p : a.outline) worst = std::max(worst, border_distance(b.outline, p - shift));
  for (const Vec2& p : b.outline) worst = std::max(worst, border_distance(a.outline, p + shift));
  return worst;
}

bool is_like(const Size& a, const Size& b, double tolerance_m, double spacing_m) {
  // A short edge may tell a large sigma; sizes that differ by more than the spacing are seen to differ.
  const double sigmas = std::min(kSigmas * std::hypot(a.sigma_m, b.sigma_m), spacing_m);
  const double tolerance = std::max(tolerance_m, sigmas);
  return std::fabs(a.box.width() - b.box.width()) <= tolerance &&
         std::fabs(a.box.height() - b.box.height()) <= tolerance &&
         difference(a, b) <= kForm * tolerance;
}

}  // namespace

std::vector<Vec2> outline_points(const VectorRing& ring) { return flattened(ring, kChord_m); }

bool is_well_measured(const FacadeOpening& opening, const FacadeWall& wall,
                      const PatternSetting& setting) {
  const bool is_known =
      opening.evidence != Evidence::kNone && opening.evidence != Evidence::kCopied;
  return is_known && opening.outline.corners.size() >= 3 &&
         opening.coverage >= setting.least_coverage &&
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
    Size size = size_of(wall.openings[i], wall.spacing_m);
    size_t p = 0;
    while (p < out.size() && !(wall.openings[out[p].best].kind == wall.openings[i].kind &&
                               is_like(sizes[p], size, setting.size_tolerance_m, wall.spacing_m)))
      ++p;
    if (p == out.size()) {
      out.push_back({i, {}, ring_box(wall.openings[i].outline)});
      sizes.push_back(std::move(size));
    }
    out[p].members.push_back(i);
  }
  for (Pattern& p : out) std::sort(p.members.begin(), p.members.end());
  return out;
}

}  // namespace jalon
