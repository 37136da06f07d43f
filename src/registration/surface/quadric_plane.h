// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>

#include "geometry/cholesky.h"
#include "registration/surface/planes.h"

namespace jalon {

/// The paraboloid h = a0 + a1 u + a2 v + a3 u^2 + a4 u v + a5 v^2 through the neighbours of a point, over the plane
/// through them; u and v are lengths divided by the scale (Girardeau-Montaut 2006, annex A.2, method 3).
struct TangentQuadric {
  Vec3 u, v, n;  ///< axes
  double scale_m =
      1;  ///< root mean square distance of the neighbours from their centroid, in the plane
  double sigma_m = 0;  ///< of their heights about the paraboloid
  Coefficients<6> a{};
  Square<6> cofactors{};  ///< covariance of a for a unit variance of the heights

  Coefficients<6> terms(const Vec3& offset_m) const {
    const double x = dot(u, offset_m) / scale_m, y = dot(v, offset_m) / scale_m;
    return {1, x, y, x * x, x * y, y * y};
  }
};

/// neighbours: positions in the tree, the point itself among them; 64 at the most are looked at.
/// Nothing where they do not fix the six coefficients: fewer than twelve, or a strip.
std::optional<TangentQuadric> local_quadric(const Octree& tree, size_t position,
                                            std::span<const uint32_t> neighbours);

/// The plane that touches it at the point: where a surface bends, as round columns do, a plane
/// through all neighbours is no plane at all. sigma_m is infinite where there is none: where the
/// neighbours scatter more than most_m about the paraboloid, or it is too steep over their plane.
SurfacePlane tangent_plane(const Octree& tree, size_t position,
                           std::span<const uint32_t> neighbours, double most_m);

}  // namespace jalon
