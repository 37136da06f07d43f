// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>

#include "registration/icp/search.h"

namespace jalon {

enum class IcpMetric : uint8_t { kPointToPoint, kPointToPlane, kPlaneToPlane };

/// When two neighbours are a pair.
struct PairRule {
  IcpMetric metric = IcpMetric::kPointToPlane;
  double most_m = 0;         ///< greatest residual
  double reach_m = 0;        ///< sideways, besides the plane's radius
  double least_cosine = 0;   ///< between the normals of both
  double plane_points = 16;  ///< whose mean a plane is: for the noise that a residual should have
};

/// What pairs are made of: neighbours of a level at a pose, and the rule. Holds references only.
struct IcpPairing {
  const IcpClouds& clouds;
  const IcpLevel& level;
  const IcpNeighbours& neighbours;
  const PairRule& rule;
  const Transform& T_reference_moving;
};

/// Which of two neighbours gives the plane.
enum class PairWay : uint8_t {
  kForth,  ///< the reference: a raw point of the moving cloud against its plane
  kBack,   ///< the moving cloud: its moved plane against a raw point of the reference
};

/// A moved point and a plane, or a moved plane and a point: residual is the moved side's height
/// above the other's. Of points alone it is their distance, and of two planes the distance that
/// their shapes leave (Segal et al. 2009). In the reference frame.
struct IcpPair {
  Vec3 place, normal;
  Vec3 offset;  ///< of the moved point from the other
  Vec3 other;   ///< the second plane's normal
  double residual_m = 0;
  double tilt_rad = 0;     ///< of the plane
  double variance_m2 = 0;  ///< that the residual should have
};

/// The pair of positions m and r by the metrics point to point and plane to plane, which have no
/// way; false when they are no pair. out is then undefined.
bool pair_of_shapes(const IcpPairing& at, uint32_t m, uint32_t r, IcpPair& out);

/// The same for any metric. Inline and with its result by reference: it is the inner loop of an
/// iteration.
inline bool pair_of(const IcpPairing& at, uint32_t m, uint32_t r, PairWay way, IcpPair& out) {
  const PairRule& rule = at.rule;
  if (rule.metric != IcpMetric::kPointToPlane) return pair_of_shapes(at, m, r, out);
  const SurfacePlanes &moving = at.clouds.moving, &reference = at.clouds.reference;
  const SurfacePlane &m_plane = moving.planes[m], &r_plane = reference.planes[r];
  // 1. Both lie on surfaces, and these face alike.
  if (!(m_plane.sigma_m <= moving.flat_m) || !(r_plane.sigma_m <= reference.flat_m)) return false;
  const Vec3 n_moving = at.T_reference_moving.direction(m_plane.unit()),
             n_reference = r_plane.unit();
  const double cosine = dot(n_moving, n_reference);
  if (!(std::abs(cosine) >= rule.least_cosine)) return false;
  // 2. Height over the plane, and not too far beside the points that the plane goes through.
  out.place = at.T_reference_moving.point(moving.place(m));
  const Vec3 d = out.place - reference.place(r);
  const bool forth = way == PairWay::kForth;
  const SurfacePlane& plane = forth ? r_plane : m_plane;
  out.normal = forth ? n_reference : n_moving;
  const double height = dot(out.normal, d);
  const double sideways2 = squared_norm(d) - height * height;
  const double reach = double{plane.radius_m} + rule.reach_m;
  if (sideways2 > reach * reach) return false;
  out.residual_m = forth ? height - plane.height_m : height + plane.height_m;
  if (!(std::abs(out.residual_m) <= rule.most_m)) return false;
  // 3. The noise to expect: of the raw point, and of the plane, which grows away from its middle.
  out.tilt_rad = plane.tilt_rad;
  const double point = forth ? m_plane.sigma_m : r_plane.sigma_m;
  const double scatter = plane.sigma_m, r2 = plane.radius_m * plane.radius_m;
  out.variance_m2 =
      point * point + scatter * scatter * (1 + 2 * sideways2 / r2) / rule.plane_points;
  return true;
}

/// A residual of a pair along one direction, and its share in the pair's weight.
struct PairTerm {
  Vec3 normal;
  double residual_m = 0, weight = 1;
};
/// Of points alone three, along the axes; of two planes three, along the axes of (C1 + C2)^-1 of
/// their shapes; point to plane has one. Returns how many. pair: of this metric.
size_t pair_terms(const IcpPair& pair, IcpMetric metric, PairTerm (&terms)[3]);

}  // namespace jalon
