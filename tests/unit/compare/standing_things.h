// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "base/random.h"
#include "geometry/vec.h"

namespace jalon::test {

/// Random points on the four sides and the top of a box that stands on z = 0 about the z axis, with noise across them.
inline std::vector<Vec3> points_of_box(const Vec3& size, size_t n, uint64_t seed,
                                       double noise_m = 0) {
  RandomStream random(seed, 41);
  const double top = size.x * size.y, side_x = size.y * size.z, side_y = size.x * size.z;
  std::vector<Vec3> out;
  while (out.size() < n) {
    Vec3 p{size.x * (random.uniform() - 0.5), size.y * (random.uniform() - 0.5),
           size.z * random.uniform()};
    double at = (top + 2 * side_x + 2 * side_y) * random.uniform();
    const double noise = noise_m * random.normal(), turn = random.below(2) != 0 ? 1 : -1;
    if ((at -= top) < 0) p.z = size.z + noise;
    else if (at < 2 * side_x) p.x = turn * (size.x / 2 + noise);
    else p.y = turn * (size.y / 2 + noise);
    out.push_back(p);
  }
  return out;
}

inline std::vector<Vec3> moved(std::vector<Vec3> points, const Transform& motion) {
  for (Vec3& p : points) p = motion.point(p);
  return points;
}

}  // namespace jalon::test
