// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "cloud/neighbourhoods.h"

#include <algorithm>
#include <cmath>

namespace jalon {

namespace {

// As in fit_plane: below this share of the largest eigenvalue the second one is rounding noise.
constexpr double kCollinear = 1e-12;

}  // namespace

bool principal_frame(const Moments& moments, PrincipalFrame& out) {
  if (moments.n < 3) return false;
  const Eigen3 eigen = symmetric_eigen(moments.covariance());
  if (!(eigen.values[1] > kCollinear * eigen.values[2])) return false;
  out.centre = moments.centroid();
  out.n = eigen.vectors[0];
  out.u = eigen.vectors[2];
  out.v = cross(out.n, out.u);
  for (size_t i = 0; i < 3; ++i) out.eigenvalues[i] = std::max(0.0, eigen.values[i]);
  return true;
}

bool local_quadric(const PrincipalFrame& frame, std::span<const Vec3> points, const Vec3& at,
                   std::vector<Vec3>& work, LocalQuadric& out) {
  const auto to_frame = [&](const Vec3& p) {
    const Vec3 d = p - frame.centre;
    return Vec3{dot(d, frame.u), dot(d, frame.v), dot(d, frame.n)};
  };
  work.clear();
  double scale = 0;
  for (const Vec3& p : points) {
    work.push_back(to_frame(p));
    scale = std::max({scale, std::fabs(work.back().x), std::fabs(work.back().y)});
  }
  if (!fit_quadric(work, scale, out.quadric)) return false;
  const Vec3 own = to_frame(at);
  out.x = own.x;
  out.y = own.y;
  return true;
}

}  // namespace jalon
