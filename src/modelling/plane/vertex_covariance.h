// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>

#include "geometry/plane.h"
#include "geometry/vec.h"
#include "modelling/plane/plane_frame.h"

namespace jalon {

/// Of a point, m2, row-major.
using Covariance3 = std::array<double, 9>;

/// A surface through a vertex, as the vertex feels it: its unit normal there and the standard deviation of its position
/// along that normal at the vertex.
struct UncertainSurface {
  Vec3 normal;
  double sigma_m = 0;
};

/// A fitted plane at a point: least certain far from its centroid, so an extrapolated corner is worth less than one
/// amid the points.
UncertainSurface plane_at(const PlaneFit& fit, const Vec3& point);
/// The same from the covariance of (nx, ny, nz, offset), row-major, as in Face. Far from the origin (7 000 km of a
/// national grid) its own rounding leaves some 1e-9 m2: take the fit where there is one.
UncertainSurface plane_at(const Plane& plane, const std::array<double, 16>& covariance,
                          const Vec3& point);

/// An edge of a face, as the plane that stands on it, upright on the face. direction: along the edge at the corner (of
/// an arc its tangent), in (u, v) of the frame, not 0. sigma_m: of its position across it where it was measured (as
/// VectorEdge::sigma_m); sigma_direction_rad turns it about that place, lever_m away from the corner.
UncertainSurface edge_at(const PlaneFrame& frame, const Vec2& direction, double sigma_m,
                         double sigma_direction_rad = 0, double lever_m = 0);

/// Covariance of the vertex in which three independent surfaces meet: with N the rows of their
/// normals and S the diagonal of their variances, C = N^-1 S N^-T (propagation of n_i . dp = e_i,
/// first order). Three planes, or a face's plane and two of its edges, or two planes and an edge
/// that ends their common line. Nothing when they do not meet in one point (|det N| < 1e-3:
/// directions within 0.06 degrees) or a sigma is not finite.
std::optional<Covariance3> vertex_covariance(const std::array<UncertainSurface, 3>& surfaces);

/// The usual case: a corner of a ring between two edges, in a plane (plane_at of the corner). The levers are half the
/// edges' lengths.
struct CornerEdge {
  Vec2 direction;  ///< along the edge at the corner
  double length_m = 0;
  double sigma_m = 0, sigma_direction_rad = 0;
};
std::optional<Covariance3> corner_covariance(const PlaneFrame& frame, const UncertainSurface& plane,
                                             const CornerEdge& before, const CornerEdge& after);

}  // namespace jalon
