// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/plane.h"
#include "geometry/vec.h"

namespace jalon {

// Legend of modelling, for all files of this room.
//
// Forms of a surface, in the order in which they come:
//   segment   points of the cloud with one label, and the plane fitted to them (room segment)
//   band      the points of it that can lie on a contour (contour/band.h)
//   chain     closed chain of contour points (Chain, ContourPiece): what the points show
//   part      stretch of a chain that is straight or an arc (ChainPart)
//   edge      EdgeShape, MeasuredEdge: a part at its measured place, with its sigma
//   ring      VectorRing: edges joined at their corners; face: VectorFace, an outline with openings
//   plane     VectorPlane: all faces of one segment
//   wall      FacadeWall: a plane of a facade whose holes have become openings or shadows
//
// Frames:
//   world     coordinates of the cloud
//   (u, v)    of a plane (PlaneFrame): u to the right, v up, for an eye in front of it
//   w, h      height in front of the plane, negative behind it; depth_m the other way: behind it
//   (t, d)    of an edge (EdgeShape): t along it, d across it to the left, into the solid
//   facade    FacadeFrame: along, outward, up
// Outlines run anticlockwise and openings clockwise: the solid is on the left of every edge.
//
// Symbols: spacing_m, typical distance of neighbouring points; sigma_m, standard deviation of what
// it stands with (an edge's place across itself, a point across its plane); set-back, how far
// contour points lie inside the true edge.

/// Drawing frame of a plane: u to the right and v up for an eye in front of it (the normal points at the eye); u x v =
/// normal.
///
/// v is the projection of world Z, so that horizontal and vertical mean what they say; on (nearly) horizontal planes u
/// is the projection of the facade's X axis (Boulaassal 2010, 4.3.1; never the principal axes, which are arbitrary on
/// square segments). origin lies near the points and off the plane: coordinates are taken relative to it, so that a
/// shift of cloud and origin by whole metres changes no bit of (u, v).
struct PlaneFrame {
  Vec3 origin, axis_u, axis_v, normal;
  double height = 0;  ///< of the plane above the origin, along the normal

  Vec2 project(const Vec3& p) const {
    const Vec3 d = p - origin;
    return {dot(d, axis_u), dot(d, axis_v)};
  }
  Vec3 lift(const Vec2& p) const {
    return origin + (axis_u * p.u + axis_v * p.v + normal * height);
  }
};

/// Before: origin is any point near the data, facade_x a horizontal unit vector along the facade.
/// After: axes orthonormal, axis_u x axis_v = normal, that of the plane.
PlaneFrame plane_frame(const Plane& plane, const Vec3& origin, const Vec3& facade_x);

}  // namespace jalon
