// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// The covariances of fitted spheres and cylinders by the way a user takes: points of a cloud in national coordinates,
// normals from their own neighbours, default parameters. The room geometry tests the fits themselves with more kinds
// of noise.
#include <doctest/doctest.h>

#include <string>

#include "segment/surface/primitive_fits.h"
#include "unit/geometry/primitives.h"
#include "unit/segment/scenes.h"

namespace jalon {
namespace {

using namespace test;

const Vec3 kGrid{652000.25, 6861000.5, 40};
const Sphere kBall{{1.3, -0.7, 0.9}, 0.9};
const Cylinder kColumn{{2.3, -0.7, 1.6}, normalized(Vec3{0.05, -0.12, 1}), 0.25};

int cloud_draws() { return std::getenv("JALON_SANITIZED") != nullptr ? 50 : 1000; }

template <class Covers>
void check_share(const std::string& what, bool one_sided, Covers&& covers) {
  int covered = 0;
  for (int i = 0; i < cloud_draws(); ++i) covered += covers(static_cast<uint64_t>(i));
  const double share = static_cast<double>(covered) / cloud_draws();
  const std::string view = one_sided ? ", one side" : ", all round";
  MESSAGE("FIGURE " << what << view << ", 3 mm noise, 5 % outliers: 95 % ellipsoid covers "
                    << 100 * share << " % of " << cloud_draws() << " draws");
  const double slack = cloud_draws() < 1000 ? 0.1 : 0;  // three sigma of 50 draws
  CHECK(share >= 0.93 - slack);
  CHECK(share <= 0.97 + slack);
}

TEST_CASE("sphere_segment__noise_and_outliers__ellipsoid_covers_the_truth") {
  Task task;
  for (const bool one_sided : {false, true}) {
    Recipe recipe;
    recipe.one_sided = one_sided;
    check_share("sphere r 0.9 m", one_sided, [&](uint64_t seed) {
      const CloudPtr cloud = cloud_of(sphere_draw(recipe, kBall, 31000 + seed).points, kGrid);
      Segment found = sphere_segment(*cloud, {}, {}, task);
      shift_origin(found, -kGrid);
      return sphere_miss(found.sphere, kBall) <= kChiSquare4;
    });
  }
}

TEST_CASE("cylinder_segment__noise_and_outliers__ellipsoid_covers_the_truth") {
  Task task;
  for (const bool one_sided : {false, true}) {
    Recipe recipe;
    recipe.one_sided = one_sided;
    check_share("cylinder r 0.25 m, 3 m", one_sided, [&](uint64_t seed) {
      const CloudPtr cloud =
          cloud_of(cylinder_draw(recipe, kColumn, 3.0, 52000 + seed).points, kGrid);
      Segment found = cylinder_segment(*cloud, {}, nullptr, {}, task);
      shift_origin(found, -kGrid);
      return cylinder_miss(found.cylinder, kColumn) <= kChiSquare5;
    });
  }
}

}  // namespace
}  // namespace jalon
