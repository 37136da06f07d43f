// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/edges/find/edge_shape.h"

#include <algorithm>
#include <numbers>

#include "modelling/edges/find/chain_parts.h"

namespace jalon {

namespace {

constexpr double kMostOpen = 0.26;  // 15 degrees, for edges so short that noise turns them
// Standard deviation of contour points about their line in spacings, a spacing apart, neighbours half dependent.
constexpr double kEdgeShapeNoise = 0.7;

// Angle by which noise turns a line of this length: that of a least-squares slope, three times.
double open_angle(double length_m, double spacing_m) {
  const double points = std::max(2.0, length_m / spacing_m);
  return std::min(kMostOpen, 3 * kEdgeShapeNoise * spacing_m * std::sqrt(12 / points) / length_m);
}

void classify(EdgeShape& shape, double spacing_m, double classes_rad, double snap_rad) {
  const Vec2& d = shape.line.direction;
  const double open = open_angle(shape.length_m, spacing_m);
  if (shape.upright_angle() <= std::max(classes_rad, open))
    shape.direction =
        std::fabs(d.u) < std::fabs(d.v) ? EdgeDirection::kVertical : EdgeDirection::kHorizontal;
  shape.snap(snap_rad, open, spacing_m);
}

}  // namespace

double EdgeShape::upright_angle() const {
  return std::asin(std::min({std::fabs(line.direction.u), std::fabs(line.direction.v), 1.0}));
}

bool EdgeShape::snap(double snap_rad, double open_rad, double spacing_m) {
  const double angle = upright_angle();
  const bool is_small = angle <= open_rad || angle * length_m / 2 <= spacing_m;
  if (is_arc || angle == 0 || snap_rad == 0 || angle > std::max(snap_rad, open_rad) || !is_small)
    return false;
  line.point = line.foot((first + last) * 0.5);
  const bool upright = std::fabs(line.direction.u) < std::fabs(line.direction.v);
  direction = upright ? EdgeDirection::kVertical : EdgeDirection::kHorizontal;
  line.direction = upright ? Vec2{0, line.direction.v < 0 ? -1.0 : 1.0}
                           : Vec2{line.direction.u < 0 ? -1.0 : 1.0, 0};
  set_ends(first, last);
  return true;
}

void EdgeShape::set_ends(const Vec2& from, const Vec2& to) {
  first = from;
  last = to;
  if (!is_arc) {
    length_m = dot(line.direction, to - from);
    return;
  }
  const Vec2 a = from - circle.centre, b = to - circle.centre;
  double angle = turn * std::atan2(cross(a, b), dot(a, b));
  if (angle <= 0) angle += 2 * std::numbers::pi;
  length_m = circle.radius * angle;
  const double c = std::cos(turn * angle / 2), s = std::sin(turn * angle / 2), size = norm(a);
  axis = Vec2{c * a.u - s * a.v, s * a.u + c * a.v} * (1 / size);
}

EdgeShape shape_of(std::span<const Vec2> chain, const ChainPart& part, double spacing_m,
                   double classes_rad, double snap_rad) {
  EdgeShape shape;
  shape.is_arc = part.is_arc;
  shape.is_guided = part.is_guided;
  shape.line = part.line;
  shape.circle = part.circle;
  shape.turn = part.turn;
  shape.set_ends(chain[part.first], chain[(part.first + part.count - 1) % chain.size()]);
  if (part.is_arc) shape.direction = EdgeDirection::kArc;
  else classify(shape, spacing_m, classes_rad, snap_rad);
  shape.shift(-kSetBack * spacing_m);
  return shape;
}

EdgeShape straight_shape(const Vec2& from, const Vec2& to) {
  EdgeShape shape;
  shape.line = {from, (to - from) * (1 / norm(to - from))};
  if (from.u == to.u) {
    shape.line.direction = {0, to.v < from.v ? -1.0 : 1.0};
    shape.direction = EdgeDirection::kVertical;
  } else if (from.v == to.v) {
    shape.line.direction = {to.u < from.u ? -1.0 : 1.0, 0};
    shape.direction = EdgeDirection::kHorizontal;
  }
  shape.set_ends(from, to);
  return shape;
}

}  // namespace jalon
