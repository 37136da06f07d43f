// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/edges/adjust/arc_tangency.h"

#include <algorithm>
#include <cmath>

namespace jalon {

namespace {

constexpr double kParallel = 0.02;  // sine: a degree
constexpr double kSigmas = 4, kSpacings = 0.5;
constexpr double kBetter =
    0.7;  // a jamb that the arc fixes so much better has its place from there
// The arc starts and ends near the jambs' own direction: within 35 degrees, as its ends are ragged. A segmental arch
// that rises by a quarter of its width starts at 37.
constexpr double kTangent = 0.8191520442889918;  // cosine

Vec2 tangent(const EdgeShape& arc, double t) {
  const Vec2 r = (arc.at(t, 0) - arc.circle.centre) * (1 / arc.circle.radius);
  return Vec2{-r.v, r.u} * arc.turn;
}

bool is_between(const EdgeShape& before, const EdgeShape& arc, const EdgeShape& after) {
  if (before.is_arc || after.is_arc || !arc.is_arc) return false;
  const Vec2 &up = before.line.direction, &down = after.line.direction;
  return std::fabs(cross(up, down)) <= kParallel && dot(up, down) < 0 &&
         dot(tangent(arc, 0), up) >= kTangent && dot(tangent(arc, arc.length_m), down) >= kTangent;
}

// A jamb as an observation of the circle: its distance from the centre is the radius.
struct Touch {
  EdgeShape& jamb;
  double side;  ///< 1: the centre lies to the left
  Coefficients<3> row;
  double misfit_m;

  Touch(EdgeShape& j, const Circle& circle) : jamb(j) {
    const double distance = jamb.line.distance(circle.centre);
    side = distance < 0 ? -1 : 1;
    const Vec2& d = jamb.line.direction;
    row = {-side * d.v, side * d.u, -1};
    misfit_m = circle.radius - side * distance;
  }
  void settle(const Circle& circle, const Cholesky<3>& factor, EdgeSource source) {
    jamb.shift(jamb.line.distance(circle.centre) - side * circle.radius);
    const auto column = factor.solve(row);
    const double sigma = std::sqrt(row[0] * column[0] + row[1] * column[1] + row[2] * column[2]);
    if (sigma < kBetter * jamb.sigma_m) jamb.source = source;
    jamb.sigma_m = std::min(jamb.sigma_m, sigma);
  }
};

}  // namespace

void touch_jambs(const EdgeInformation& information, double spacing_m, EdgeShape& before,
                 EdgeShape& arc, EdgeShape& after) {
  if (!is_between(before, arc, after)) return;
  Touch touches[] = {{before, arc.circle}, {after, arc.circle}};
  // 1. The arc's own measurements and the jambs'.
  EdgeInformation matrix = information;
  Coefficients<3> right{};
  for (const Touch& t : touches) {
    const double sigma = std::hypot(t.jamb.sigma_m, arc.sigma_m);
    if (std::fabs(t.misfit_m) > kSigmas * sigma + kSpacings * spacing_m) return;
    const double weight = 1 / (t.jamb.sigma_m * t.jamb.sigma_m);
    for (size_t i = 0; i < 3; ++i) {
      right[i] += weight * t.row[i] * t.misfit_m;
      for (size_t j = 0; j < 3; ++j) matrix[3 * i + j] += weight * t.row[i] * t.row[j];
    }
  }
  Cholesky<3> factor;
  if (!factor.factor(matrix)) return;
  const auto x = factor.solve(right);
  arc.circle = {arc.circle.centre + Vec2{x[0], x[1]}, arc.circle.radius + x[2]};
  // 2. The jambs touch it.
  for (Touch& t : touches) t.settle(arc.circle, factor, arc.source);
  // 3. Half a circle, from jamb to jamb.
  arc.set_ends(before.line.foot(arc.circle.centre), after.line.foot(arc.circle.centre));
}

}  // namespace jalon
