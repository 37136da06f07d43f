// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/arc_tangency.h"

#include <cmath>

namespace jalon {

namespace {

constexpr double kParallel = 0.02;  // sine: a degree
constexpr double kSigmas = 4, kSpacings = 0.5;
// The arc starts and ends near the jambs' own direction: within 25 degrees.
const double kTangent = std::cos(25 * 3.14159265358979323846 / 180);

Vec2 tangent(const EdgeShape& arc, double t) {
  const Vec2 r = (arc.at(t, 0) - arc.circle.centre) * (1 / arc.circle.radius);
  return Vec2{-r.v, r.u} * arc.turn;
}

}  // namespace

bool touch_jambs(const EdgeShape& before, const EdgeShape& after, const EdgeInformation& information, double spacing_m,
                 EdgeShape& arc) {
  if (before.is_arc || after.is_arc || !arc.is_arc) return false;
  const Vec2 along = before.line.direction;
  if (std::fabs(cross(along, after.line.direction)) > kParallel || dot(along, after.line.direction) > 0) return false;
  if (dot(tangent(arc, 0), along) < kTangent || dot(tangent(arc, arc.length_m), after.line.direction) < kTangent)
    return false;
  // 1. The circle between the jambs.
  const Vec2& centre = arc.circle.centre;
  const double to_before = before.line.distance(centre), to_after = after.line.distance(centre);
  const double radius = std::fabs(to_before + to_after) / 2;
  const Vec2 left{-along.v, along.u};
  const double aside = (to_after - to_before) / 2, wider = radius - arc.circle.radius;
  const double sigma = std::sqrt(before.sigma_m * before.sigma_m + after.sigma_m * after.sigma_m +
                                 arc.sigma_m * arc.sigma_m);
  const double allowed = kSigmas * sigma + kSpacings * spacing_m;
  if (std::fabs(aside) > allowed || std::fabs(wider) > allowed) return false;
  // 2. Along the jambs: the least change of the arc's weighted squares.
  const Coefficients<3> fixed{left.u * aside, left.v * aside, wider}, free{along.u, along.v, 0};
  double numerator = 0, denominator = 0;
  for (size_t i = 0; i < 3; ++i)
    for (size_t j = 0; j < 3; ++j) {
      numerator += free[i] * information[3 * i + j] * fixed[j];
      denominator += free[i] * information[3 * i + j] * free[j];
    }
  if (!(denominator > 0)) return false;
  arc.circle = {centre + left * aside - along * (numerator / denominator), radius};
  // 3. Half a circle, from jamb to jamb.
  arc.set_ends(before.line.foot(arc.circle.centre), after.line.foot(arc.circle.centre));
  return true;
}

}  // namespace jalon
