// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "geometry/symmetric_eigen.h"
#include "registration/icp/pairs.h"

namespace jalon {

namespace {

constexpr double kFlatShape =
    1e-3;  // variance across a plane where along it it is 1 (Segal, Haehnel & Thrun 2009)

// C1 + C2 of two planes: I - (1 - e) n n^T each.
Symmetric3 shape_of(const Vec3& a, const Vec3& b) {
  const double s = 1 - kFlatShape;
  return {2 - s * (a.x * a.x + b.x * b.x), -s * (a.x * a.y + b.x * b.y),
          -s * (a.x * a.z + b.x * b.z),    2 - s * (a.y * a.y + b.y * b.y),
          -s * (a.y * a.z + b.y * b.z),    2 - s * (a.z * a.z + b.z * b.z)};
}

}  // namespace

bool pair_of_shapes(const IcpPairing& at, uint32_t m, uint32_t r, IcpPair& out) {
  const PairRule& rule = at.rule;
  const SurfacePlanes &moving = at.clouds.moving, &reference = at.clouds.reference;
  const SurfacePlane &m_plane = moving.planes[m], &r_plane = reference.planes[r];
  out.place = at.T_reference_moving.point(moving.place(m));
  out.offset = out.place - reference.place(r);
  out.tilt_rad = 0;
  if (rule.metric == IcpMetric::kPointToPoint) {
    out.residual_m = norm(out.offset);
  } else {
    if (!std::isfinite(m_plane.sigma_m) || !std::isfinite(r_plane.sigma_m)) return false;
    out.normal = r_plane.unit();
    out.other = at.T_reference_moving.direction(m_plane.unit());
    if (!(std::abs(dot(out.normal, out.other)) >= rule.least_cosine)) return false;
    PairTerm terms[3];
    double squares = 0;
    for (size_t k = 0; k < pair_terms(out, rule.metric, terms); ++k)
      squares += terms[k].weight * terms[k].residual_m * terms[k].residual_m;
    out.residual_m = std::sqrt(squares);
  }
  const double one = std::hypot(moving.noise_m, reference.noise_m);
  out.variance_m2 = one * one;
  // Planes may be met sideways as far as their points reach; points alone have the distance for that.
  const double sideways = rule.metric == IcpMetric::kPointToPoint
                              ? 0
                              : double{m_plane.radius_m} + double{r_plane.radius_m};
  return norm(out.offset) <= rule.most_m + rule.reach_m + sideways && out.residual_m <= rule.most_m;
}

size_t pair_terms(const IcpPair& pair, IcpMetric metric, PairTerm (&terms)[3]) {
  if (metric == IcpMetric::kPointToPlane) {
    terms[0] = {pair.normal, pair.residual_m, 1};
    return 1;
  }
  if (metric == IcpMetric::kPointToPoint) {
    for (int k = 0; k < 3; ++k) {
      terms[k].normal = {};
      terms[k].normal[k] = 1;
      terms[k].residual_m = pair.offset[k];
      terms[k].weight = 1;
    }
    return 3;
  }
  const Eigen3 e = symmetric_eigen(shape_of(pair.normal, pair.other));
  for (size_t k = 0; k < 3; ++k)
    terms[k] = {e.vectors[k], dot(e.vectors[k], pair.offset), 2 * kFlatShape / e.values[k]};
  return 3;
}

}  // namespace jalon
