// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/polar_covariance.h"

namespace jalon {

// The columns of J: along the ray; sideways, d cos v long; upward across the ray, d long. They stay defined overhead.
Symmetric3 polar_covariance(const Vec3& ray, const Vec3& up, const PolarSigmas& sigmas) {
  const double d = norm(ray), height = dot(ray, up);
  const Vec3 along = ray / d, sideways = cross(ray, up);
  const double reach = norm(sideways);  // d cos v
  const Vec3 level = reach > 0 ? sideways / reach : Vec3{};
  const Vec3 upward = cross(level, along);
  const double tilt = height * sigmas.levelling_rad;  // d sin v
  const double lateral = sigmas.lateral_m * sigmas.lateral_m;
  Symmetric3 c{lateral, 0, 0, lateral, 0, lateral};
  add_square(c, along, sigmas.range_m * sigmas.range_m - lateral);
  add_square(c, level, reach * reach * sigmas.horizontal_rad * sigmas.horizontal_rad + tilt * tilt);
  if (reach > 0) {
    add_square(c, upward, d * d * sigmas.vertical_rad * sigmas.vertical_rad);
    return c;
  }
  // Straight up or down the vertical angle moves the point in an unknown direction: half of its variance in each.
  const double half = d * d * sigmas.vertical_rad * sigmas.vertical_rad / 2;
  const Vec3 other = normalized(std::fabs(along.x) < 0.5 ? cross(along, Vec3{1, 0, 0})
                                                         : cross(along, Vec3{0, 1, 0}));
  add_square(c, other, half);
  add_square(c, cross(along, other), half);
  return c;
}

double point_sigma(const Symmetric3& covariance) {
  return std::sqrt(covariance[0] + covariance[3] + covariance[5]);
}

double variance_along(const Symmetric3& c, const Vec3& n) {
  return c[0] * n.x * n.x + c[3] * n.y * n.y + c[5] * n.z * n.z +
         2 * (c[1] * n.x * n.y + c[2] * n.x * n.z + c[4] * n.y * n.z);
}

}  // namespace jalon
