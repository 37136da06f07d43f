// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "unit/geometry/primitives.h"

#include <doctest/doctest.h>

#include <string>

#include "geometry/circle.h"

namespace jalon {
namespace {

using namespace test;

struct Coverage {
  int covered = 0, failed = 0, all = 0;
  double radius_errors_m = 0;  ///< sum
  double share() const { return static_cast<double>(covered) / all; }
};

std::string name_of(const Recipe& r) {
  const char* noise[] = {"normal", "isotropic", "beam"};
  return std::string(r.one_sided ? "one-sided" : "all round") + ", " +
         noise[static_cast<int>(r.noise)] + " noise, " +
         (r.near ? "outliers near" : "outliers anywhere");
}

// All of them in the long form; by default the mildest and the harshest of each coverage.
std::vector<Recipe> recipes() {
  std::vector<Recipe> out;
  for (const bool one_sided : {false, true})
    for (const Noise noise : {Noise::kNormal, Noise::kIsotropic, Noise::kBeam})
      for (const bool near : {false, true}) {
        if (!is_full() && (noise == Noise::kIsotropic || near != (noise == Noise::kBeam))) continue;
        Recipe r;
        r.one_sided = one_sided;
        r.noise = noise;
        r.near = near;
        out.push_back(r);
      }
  return out;
}

uint64_t seed_of(size_t recipe, int draw) {
  return 100000 * (recipe + 1) + static_cast<uint64_t>(draw);
}

void check_coverage(const std::string& what, const Recipe& recipe, const Coverage& c) {
  MESSAGE("FIGURE " << what << ", " << name_of(recipe) << ": 95 % ellipsoid covers "
                    << 100 * c.share() << " % of " << c.all << " draws, " << c.failed
                    << " failed, radius biased by " << 1e6 * c.radius_errors_m / c.all << " um");
  CHECK(c.failed == 0);
  const double slack = c.all < 1000 ? 0.05 : 0;
  CHECK(c.share() >= 0.93 - slack);
  CHECK(c.share() <= 0.97 + slack);
}

TEST_CASE("fit_sphere__noise_and_outliers__ellipsoid_covers_the_truth") {
  const Sphere truth{{1.3, -0.7, 0.9}, 0.9};
  Task task;
  const std::vector<Recipe> all = recipes();
  for (size_t r = 0; r < all.size(); ++r) {
    Coverage c;
    for (int i = 0; i < draw_count(); ++i) {
      const Draw draw = sphere_draw(all[r], truth, seed_of(r, i));
      SphereFit fit;
      ++c.all;
      if (!fit_sphere(draw.points, {}, task, fit)) {
        ++c.failed;
        continue;
      }
      c.covered += sphere_miss(fit, truth) <= kChiSquare4;
      c.radius_errors_m += fit.sphere.radius - truth.radius;
    }
    check_coverage("sphere r 0.9 m", all[r], c);
  }
}

TEST_CASE("fit_cylinder__noise_and_outliers__ellipsoid_covers_the_truth") {
  const Cylinder truth{{2.3, -0.7, 1.6}, normalized(Vec3{0.05, -0.12, 1}), 0.25};
  Task task;
  const std::vector<Recipe> all = recipes();
  for (size_t r = 0; r < all.size(); ++r) {
    Coverage c;
    for (int i = 0; i < draw_count(); ++i) {
      const Draw draw = cylinder_draw(all[r], truth, 3.0, seed_of(r, i));
      CylinderFit fit;
      ++c.all;
      if (!fit_cylinder(draw.points, draw.normals, {}, task, fit)) {
        ++c.failed;
        continue;
      }
      c.covered += cylinder_miss(fit, truth) <= kChiSquare5;
      c.radius_errors_m += fit.cylinder.radius - truth.radius;
    }
    check_coverage("cylinder r 0.25 m", all[r], c);
  }
}

}  // namespace
}  // namespace jalon
