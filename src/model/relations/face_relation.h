// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/nine_intersection.h"
#include "model/relations/placed_face.h"

namespace jalon {

/// The 9-intersection of two faces. In one plane: of their regions, the exteriors in that plane. Else of two surfaces
/// in space, which share points of the line where their planes meet alone: cut there by the rings of both, each piece
/// judged by its middle; a face keeps surface and border outside the other. What lies within tolerance of a ring or
/// plane is on it. O(n m).
NineIntersection face_intersection(const PlacedFace& a, const PlacedFace& b, double tolerance);

/// Least distance between points of two faces, 0 where they touch. O(n m).
double face_distance(const PlacedFace& a, const PlacedFace& b, double tolerance);

/// The line of two planes, through the point of it nearest to `near`; false for parallel ones.
bool common_line(const Plane& a, const Plane& b, const Vec3& near, Vec3& point, Vec3& direction);

/// Places along a line in a face's plane where the rings cross or touch it, ascending, in metres from `point`.
std::vector<double> ring_crossings(const PlacedFace& face, const Vec3& point, const Vec3& direction,
                                   double tolerance);

}  // namespace jalon
