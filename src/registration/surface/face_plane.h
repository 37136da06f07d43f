// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "geometry/symmetric_eigen.h"
#include "geometry/vec.h"
#include "spatial/octree/octree.h"

namespace jalon {

/// Points within so many noises of the plane of a face belong to it.
constexpr double kFaceNoises = 3;

/// Sums of a plane's points about their centroid, in grid steps from one point.
struct PlanePoints {
  Symmetric3 scatter{};
  Vec3 offset;  ///< the centroid
  size_t count = 0;
};

/// The neighbours that lie on one face with the point at a position; nothing when no face is found.
/// Near an edge half of the neighbours lie around the corner and the plane through all is slanted;
/// narrow faces, such as the reveals of windows, have no other points.
/// 1. Planes through the point and each two of its nearest ones, scored by the distances of all
///    (Torr & Zisserman 2000).
/// 2. Least squares through those near the best one, twice.
///
/// Before: neighbours nearest first, the point itself among them; noise, the standard deviation of
/// the points, in grid steps. After: six points or more, spread in two directions, and the point
/// itself within kFaceNoises of their plane. Costs 15 planes by 32 points at the most.
std::optional<PlanePoints> points_of_face(const Octree& tree, size_t position,
                                          std::span<const uint32_t> neighbours, double noise);

}  // namespace jalon
