// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <cstdlib>

#include "base/distributions.h"
#include "unit/registration/target_scenes.h"

namespace jalon {
namespace {

using namespace test;

int runs() { return std::getenv("JALON_SANITIZED") != nullptr ? 100 : 1000; }

Layout layout_of(const char* name, std::vector<Vec3> places) {
  Layout out{name, std::move(places), {}, {}};
  for (size_t i = 0; i < out.places.size(); ++i) {
    out.reference.push_back(isotropic(0.003));
    out.moving.push_back(isotropic(0.002));
  }
  return out;
}

const std::vector<Vec3> kRoom = {{8, 2, 0},  {-6, 7, 1.5}, {-9, -8, 0.5},
                                 {5, -7, 3}, {1, 10, 4},   {10, -2, 2}};

// Places along a street, 30 m long and 0.5 m wide.
Layout narrow() {
  return layout_of("narrow",
                   {{2, 4, 1}, {9, 4.2, 1.4}, {17, 3.9, 0.9}, {25, 4.3, 1.3}, {31, 3.8, 1}});
}

Layout mixed() {
  Layout out = layout_of("mixed covariances", kRoom);
  for (size_t i = 0; i < out.places.size(); ++i) {
    out.moving[i] = along_ray(out.places[i], 0.001 + 0.002 * static_cast<double>(i), 0.0005);
    out.reference[i] = i % 2 == 0 ? isotropic(0.001) : along_ray({0, 0, 1}, 0.02, 0.008);
  }
  return out;
}

Layout similar() {
  Layout out = mixed();
  out.name = "similarity";
  out.scale = 1.0003;
  out.params = R"({"transform": "similarity"})";
  return out;
}

}  // namespace

TEST_CASE("targets__the_95_percent_ellipsoid_covers_the_truth_in_93_to_97_percent") {
  const double limit = chi_square_quantile(6, 0.95);
  for (const Layout& layout :
       {layout_of("good", kRoom), layout_of("three", {{8, 2, 0}, {-6, 7, 1.5}, {-9, -8, 0.5}}),
        narrow(), mixed(), similar()}) {
    int covered = 0, scales = 0;
    for (int draw = 0; draw < runs(); ++draw) {
      RandomStream random(2026, static_cast<uint64_t>(draw));
      const Transform truth = any_motion(random, layout.scale);
      const Registration r = registered(measured_sides(layout, truth, random), layout.params);
      covered += squared_length<6>(r.covariance, pose_error(r, truth)) <= limit;
      const double sigma = r.summary.require("scale_sigma").number(0);
      scales += std::fabs(r.scale - layout.scale) <= 1.959964 * sigma;
    }
    const double share = static_cast<double>(covered) / runs(),
                 of_scale = static_cast<double>(scales) / runs();
    MESSAGE("FIGURE targets coverage, " << layout.name << ": " << 100 * share << " %");
    CHECK(share >= (runs() == 1000 ? 0.93 : 0.88));
    CHECK(share <= (runs() == 1000 ? 0.97 : 1.0));
    if (layout.scale == 1) continue;
    MESSAGE("FIGURE targets coverage of the scale: " << 100 * of_scale << " %");
    CHECK(of_scale >= (runs() == 1000 ? 0.93 : 0.88));
    CHECK(of_scale <= (runs() == 1000 ? 0.97 : 1.0));
  }
}

// The covariance is known up to a factor: the ellipsoid is that of F(6, redundancy), here from the share of squares.
TEST_CASE("targets__with_an_estimated_sigma0_cover_as_the_f_distribution_says") {
  Layout layout = mixed();
  int covered = 0;
  for (int draw = 0; draw < runs(); ++draw) {
    RandomStream random(77, static_cast<uint64_t>(draw));
    const Transform truth = any_motion(random);
    TargetSides sides = measured_sides(layout, truth, random);
    for (auto* side : {&sides.reference, &sides.moving})
      for (Target& target : *side)
        for (double& c : target.covariance) c *= 25;  // five times too pessimistic: must not matter
    const Registration r = registered(sides, R"({"sigma0": "estimated"})");
    const double squares = squared_length<6>(r.covariance, pose_error(r, truth)), f = 12;
    covered += beta_tail(3, f / 2, squares / (squares + f)) >= 0.05;
  }
  const double share = static_cast<double>(covered) / runs();
  MESSAGE("FIGURE targets coverage, sigma0 estimated: " << 100 * share << " %");
  CHECK(share >= (runs() == 1000 ? 0.93 : 0.88));
  CHECK(share <= (runs() == 1000 ? 0.97 : 1.0));
}

}  // namespace jalon
