// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "base/random.h"
#include "compare/overlap/overlap.h"

namespace jalon::test {

/// A floor and two walls of different size, off the origin.
inline std::vector<Vec3> hall_points(uint64_t seed, size_t count = 9000) {
  std::vector<Vec3> out;
  RandomStream random(seed, 1);
  for (size_t k = 0; k < count; ++k) {
    const double u = random.uniform(), v = random.uniform();
    out.push_back(k % 3 == 0   ? Vec3{30 + 20 * u, 50 + 9 * v, 2}
                  : k % 3 == 1 ? Vec3{30 + 20 * u, 50, 2 + 5 * v}
                               : Vec3{30, 50 + 9 * u, 2 + 5 * v});
  }
  return out;
}

template <class F>
Cloud cloud_by(const std::vector<Vec3>& points, F&& moved) {
  Buffer<double> xyz(3 * points.size());
  for (size_t i = 0; i < points.size(); ++i) {
    const Vec3 p = moved(points[i]);
    for (int k = 0; k < 3; ++k) xyz[3 * i + static_cast<size_t>(k)] = p[k];
  }
  return make_cloud(std::move(xyz));
}

inline Cloud cloud_by(const std::vector<Vec3>& points) {
  return cloud_by(points, [](const Vec3& p) { return p; });
}

}  // namespace jalon::test
