// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// Window reveals: narrow strips at right angles to a dense wall, seen at a grazing angle.
#include <doctest/doctest.h>

#include <cmath>

#include "unit/segment/scenes.h"

using namespace jalon;
using namespace jalon::test;

namespace {

constexpr double kNoise_m = 0.003;

// A wall in y = 0, x <= 0, with columns of points every 15 mm, and the reveal x = 0 behind its edge, with the given
// number of columns in its 0.2 m; noise along the ray, 15 degrees off the reveal's plane.
Scene wall_and_reveal(int reveal_columns, uint64_t seed) {
  Scene scene;
  RandomStream random(seed, 3);
  const Vec3 ray{0.258819, 0.965926, 0};
  const auto column = [&](double x, double y, int face) {
    for (int k = 0; k < 130; ++k) {
      scene.points.push_back(Vec3{x, y, 0.015 * k} + kNoise_m * random.normal() * ray);
      scene.faces.push_back(face);
    }
  };
  for (int i = 0; i < 130; ++i) column(-0.002 - 0.015 * i, 0, 1);
  for (int i = 0; i < reveal_columns; ++i) column(0, 0.2 * (i + 0.5) / reveal_columns, 2);
  return scene;
}

}  // namespace

TEST_CASE("a single column of a scan is no plane") {
  for (uint64_t seed = 1; seed <= 10; ++seed) {
    const Segmentation s =
        run(cloud_of(wall_and_reveal(1, seed).points), ransac_params("{}", seed));
    REQUIRE(s.segments.size() == 1);
    CHECK(std::fabs(s.segments[0].fit.plane.normal.y) > 0.99999);
  }
}

TEST_CASE("a reveal of three columns keeps its direction and the wall its edge") {
  double worst = 0, stolen = 0;
  for (uint64_t seed = 1; seed <= 10; ++seed) {
    const Scene scene = wall_and_reveal(3, seed);
    const Segmentation s = run(cloud_of(scene.points), ransac_params("{}", seed));
    REQUIRE(s.segments.size() == 2);
    const PlaneFit& reveal = s.segments[1].fit;
    worst = std::max(worst, std::hypot(reveal.plane.normal.y, reveal.plane.normal.z));
    const auto of_wall = static_cast<double>(overlap(scene, s, 1, 2));
    stolen = std::max(stolen, of_wall / static_cast<double>(reveal.n));
  }
  MESSAGE("worst angle " << worst << " rad, worst share of the wall's points " << stolen);
  CHECK(worst < 0.0175);
  CHECK(stolen < 0.1);
}
