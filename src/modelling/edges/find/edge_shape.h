// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <span>

#include "base/numbers.h"
#include "geometry/circle.h"
#include "modelling/edges/find/edge_line.h"
#include "modelling/plane/vector_plane.h"

namespace jalon {

/// A straight or curved edge between its future nodes, with coordinates of its own: t runs along it from its first
/// contour point, d across it to the left, into the solid.
struct EdgeShape {
  bool is_arc = false;
  bool is_guided = false;  ///< of few points, on a line that others lie on
  EdgeLine line;
  Circle circle;
  double turn = 0;      ///< arcs: 1 = anticlockwise (the solid inside the circle), -1 = clockwise
  Vec2 axis{1, 0};      ///< arcs: unit vector from the centre to half way along
  Vec2 first, last;     ///< contour points at its ends
  double length_m = 0;  ///< between them, along it
  double sigma_m = kNaN;
  EdgeDirection direction = EdgeDirection::kInclined;
  EdgeSource source = EdgeSource::kContour;

  /// (t, d) of a point; t of an arc within half a circle of its middle.
  Vec2 local(const Vec2& p) const {
    if (!is_arc) return {dot(line.direction, p - first), line.distance(p)};
    const Vec2 to = p - circle.centre;
    return {length_m / 2 + turn * circle.radius * std::atan2(cross(axis, to), dot(axis, to)),
            turn * (circle.radius - norm(to))};
  }
  /// The point of the edge at t, moved by d into the solid.
  Vec2 at(double t, double d) const {
    if (!is_arc)
      return line.foot(first) + line.direction * t + Vec2{-line.direction.v, line.direction.u} * d;
    const double angle = turn * (t - length_m / 2) / circle.radius, c = std::cos(angle),
                 s = std::sin(angle);
    return circle.centre +
           Vec2{c * axis.u - s * axis.v, s * axis.u + c * axis.v} * (circle.radius - turn * d);
  }
  /// Area at depth d over area on the edge: 1 for lines.
  double widening(double d) const {
    return is_arc ? (circle.radius - turn * d) / circle.radius : 1;
  }
  /// Sets the ends, and with them length and axis.
  void set_ends(const Vec2& from, const Vec2& to);
  /// Of a line to the nearer of vertical and horizontal.
  double upright_angle() const;
  /// Makes a line exactly vertical or horizontal about its middle when it is so within snap_rad and its ends move by no
  /// more than the spacing, or within open_rad, which noise explains.
  bool snap(double snap_rad, double open_rad, double spacing_m);
  /// Moves the edge by d into the solid.
  void shift(double d) {
    if (is_arc) circle.radius -= turn * d;
    else line.point = line.point + Vec2{-line.direction.v, line.direction.u} * d;
  }
};

struct ChainPart;

/// The edge of a part of a contour, moved outward by the mean set-back of contour points.
/// classes_rad: lines this near to vertical or horizontal are classed so. snap_rad: and made
/// exactly so, unless their ends would move by more than the spacing or what noise explains. After:
/// ends, length and, of arcs, the axis are set; sigma is NaN and the source the contour.
EdgeShape shape_of(std::span<const Vec2> chain, const ChainPart& part, double spacing_m,
                   double classes_rad, double snap_rad);
/// A straight edge from one corner to another, of the class of its exact direction.
EdgeShape straight_shape(const Vec2& from, const Vec2& to);

/// Contour points lie, on average, this share of the spacing inside straight edges: 0.5 on a
/// regular grid, whose border runs half a step beyond its points, 0.2 measured on points scattered
/// at random, whose contour follows the outermost.
constexpr double kSetBack = 0.35;

}  // namespace jalon
