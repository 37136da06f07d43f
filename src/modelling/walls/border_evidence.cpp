// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/walls/border_evidence.h"

#include <algorithm>
#include <cmath>

#include "geometry/polygon2.h"
#include "modelling/plane/ring_tools.h"

namespace jalon {

namespace {

constexpr double kReach =
    2;  // cells from the outline to the wall's outermost points, gaps included
constexpr double kBorderEvidenceChordOfCell = 0.1;

// A step along the outline, and the wall's point nearest to it.
struct Step {
  Vec2 middle, inward;
  bool is_hidden = false;
  double nearest_m = INFINITY;
  Vec2 point;
};

// The upper edge of a sill is left out: no point of the wall lies below it.
std::vector<Step> steps_along(const FacadeOpening& opening, const WallMap& map) {
  const std::vector<Vec2> ring =
      flattened(opening.outline, kBorderEvidenceChordOfCell * map.cell_m);
  std::vector<Step> out;
  for (size_t i = opening.ends_at_sill ? 1 : 0; i < ring.size(); ++i) {
    const Vec2 a = ring[i], d = ring[(i + 1) % ring.size()] - a;
    const double length = norm(d);
    const int count = std::max(1, static_cast<int>(std::lround(length / map.cell_m)));
    if (!(length > 0)) continue;
    const Vec2 inward = Vec2{-d.v, d.u} * (1 / length);  // anticlockwise: the inside is on the left
    for (int k = 0; k < count; ++k) {
      Step step;
      step.middle = a + d * ((k + 0.5) / count);
      step.inward = inward;
      step.is_hidden = map.at(step.middle + inward * map.cell_m) == WallCell::kHidden;
      out.push_back(step);
    }
  }
  return out;
}

// Gives each of the wall's points beside the opening to its nearest step: a hash of steps by cell.
void give_points(const HoleSurvey& survey, uint32_t own_label, const WallMap& map,
                 std::vector<Step>& steps) {
  const double bin = kReach * map.cell_m;
  const auto key = [&](int64_t c, int64_t r) { return r * (int64_t{1} << 32) + c; };
  const auto column = [&](double x, double origin) {
    return static_cast<int64_t>(std::floor((x - origin) / bin));
  };
  std::vector<std::pair<int64_t, uint32_t>> bins;
  for (size_t s = 0; s < steps.size(); ++s)
    bins.emplace_back(
        key(column(steps[s].middle.u, map.origin.u), column(steps[s].middle.v, map.origin.v)),
        static_cast<uint32_t>(s));
  std::sort(bins.begin(), bins.end());
  for (const HolePoint& point : survey.points) {
    if (point.label != own_label) continue;
    const Vec2 p{point.u, point.v};
    const int64_t c = column(p.u, map.origin.u), r = column(p.v, map.origin.v);
    Step* nearest = nullptr;
    double least = bin * bin;
    for (int64_t dr = -1; dr <= 1; ++dr) {
      auto at =
          std::lower_bound(bins.begin(), bins.end(), std::pair{key(c - 1, r + dr), uint32_t{0}});
      for (; at != bins.end() && at->first <= key(c + 1, r + dr); ++at) {
        const Vec2 d = p - steps[at->second].middle;
        if (dot(d, d) >= least) continue;
        least = dot(d, d);
        nearest = &steps[at->second];
      }
    }
    if (nearest == nullptr) continue;
    const double out = -dot(p - nearest->middle, nearest->inward);
    if (std::fabs(out) < std::fabs(nearest->nearest_m)) {
      nearest->nearest_m = out;
      nearest->point = p;
    }
  }
}

}  // namespace

void measure_border(const FacadeWall& wall, const HoleSurvey& survey, FacadeOpening& opening) {
  std::vector<Step> steps = steps_along(opening, wall.map);
  give_points(survey, wall.label, wall.map, steps);
  double sum = 0, squares = 0;
  for (const Step& step : steps) {
    if (step.is_hidden || !std::isfinite(step.nearest_m)) continue;
    opening.border_points.push_back(step.point);
    sum += step.nearest_m;
    squares += step.nearest_m * step.nearest_m;
  }
  const auto n = static_cast<double>(opening.border_points.size());
  opening.coverage = steps.empty() ? 0 : n / static_cast<double>(steps.size());
  if (n > 1) opening.residual_m = std::sqrt(std::max(0.0, squares / n - (sum / n) * (sum / n)));
}

}  // namespace jalon
