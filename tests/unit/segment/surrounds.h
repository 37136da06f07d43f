// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "unit/segment/scenes.h"

namespace jalon::test {

/// After Boulaassal 2010, 3.4.3.6: wall 12 x 9 m with 12 windows; surrounds 0.15 m wide at -0.06,
/// joinery 0.08 m wide at +0.20; 60 000 points, and those on the glass at +0.22 (face 4).
inline Scene surrounds(uint64_t seed, size_t glass_points_a_window = 0) {
  Scene scene;
  RandomStream random(seed, 2);
  const double sigma = 0.006;
  size_t wall = 0;
  while (wall < 45000) {
    const Vec3 p{12 * random.uniform(), 0, 9 * random.uniform()};
    const double x = std::fmod(p.x, 3.0) - 0.9, z = std::fmod(p.z, 3.0) - 0.6;
    if (x > -0.15 && x < 1.35 && z > -0.15 && z < 1.95) continue;
    scene.points.push_back(p + Vec3{0, sigma * random.normal(), 0});
    scene.faces.push_back(1);
    ++wall;
  }
  const auto frame = [&](int face, Vec3 c, double w, double h, double width, double y,
                         size_t count) {
    for (size_t i = 0; i < count;) {
      const double x = w * random.uniform(), z = h * random.uniform();
      if (x > width && x < w - width && z > width && z < h - width) continue;
      scene.points.push_back(c + Vec3{x, y + sigma * random.normal(), z});
      scene.faces.push_back(face);
      ++i;
    }
  };
  for (int column = 0; column < 4; ++column)
    for (int row = 0; row < 3; ++row) {
      const Vec3 c{3.0 * column + 0.9, 0, 3.0 * row + 0.6};
      frame(2, c - Vec3{0.15, 0, 0.15}, 1.5, 2.1, 0.15, -0.06, 700);
      frame(3, c, 1.2, 1.8, 0.08, 0.20, 500);
      if (glass_points_a_window == 0) continue;
      for (size_t i = 0; i < glass_points_a_window; ++i) {
        const double x = 0.08 + 1.04 * random.uniform(), z = 0.08 + 1.64 * random.uniform();
        scene.points.push_back(c + Vec3{x, 0.22 + sigma * random.normal(), z});
        scene.faces.push_back(4);
      }
    }
  return scene;
}

}  // namespace jalon::test
