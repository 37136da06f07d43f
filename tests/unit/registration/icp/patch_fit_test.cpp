// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// One patch of points of both clouds against the shift that was put between them, and its scatter.

#include <doctest/doctest.h>

#include <cmath>

#include "base/random.h"
#include "registration/icp/patch_fit.h"

using namespace jalon;

namespace {

constexpr double kNoise_m = 0.002;

// n points of either cloud over a square of 2 m; the moving ones lie a shift above z = bend (x^2 + y^2).
std::vector<PatchPoint> patch_points(int n, double shift_m, double bend, double noise_m,
                                     uint64_t draw) {
  RandomStream random(91, draw);
  std::vector<PatchPoint> out;
  for (int i = 0; i < 2 * n; ++i) {
    const double x = 2 * random.uniform() - 1, y = 2 * random.uniform() - 1;
    const bool moving = i % 2 == 1;
    const double z = bend * (x * x + y * y) + (moving ? shift_m : 0) + noise_m * random.normal();
    out.push_back({{x, y, z}, moving});
  }
  return out;
}

PatchSums patch_of(const std::vector<PatchPoint>& points, double noise_m = kNoise_m,
                   const RobustKernel& kernel = {KernelKind::kNone, kNoise_m}) {
  PatchSums out;
  add_patch(points, {0, 0, 1}, noise_m, kernel, {{}, 1}, out);
  return out;
}

struct Solved {
  double shift_m, variance_m2;
};

// The shift along z and its variance N^-1 scatter N^-1; a patch across z holds two turns besides.
Solved shift_of(const PatchSums& sums) {
  constexpr size_t kHeld[] = {0, 1, 5};
  Square<3> normal, scatter;
  Coefficients<3> right;
  for (size_t r = 0; r < 3; ++r) {
    right[r] = sums.right[kHeld[r]];
    for (size_t c = 0; c < 3; ++c) {
      normal[3 * r + c] = sums.normal[6 * kHeld[r] + kHeld[c]];
      scatter[3 * r + c] = sums.scatter[6 * kHeld[r] + kHeld[c]];
    }
  }
  Cholesky<3> factor;
  REQUIRE(factor.factor(normal));
  return {factor.solve(right)[2], sandwich<3>(factor.inverse(), scatter)[8]};
}

}  // namespace

TEST_CASE("add_patch__takes_the_shift_between_the_clouds_back_with_the_scatter_it_states") {
  constexpr int kDraws = 3000;
  constexpr double kShift_m = 0.0005;
  for (const double bend : {0.0, 0.3}) {
    // So few that what a surface takes up of their scatter shows: 3 and 6 coefficients.
    const int n = bend > 0 ? 16 : 8;
    double sum = 0, squares = 0, stated = 0;
    for (uint64_t draw = 0; draw < kDraws; ++draw) {
      const PatchSums patch = patch_of(patch_points(n, kShift_m, bend, kNoise_m, draw));
      REQUIRE(patch.patches == 1);
      const Solved found = shift_of(patch);
      sum += found.shift_m;
      squares += found.shift_m * found.shift_m;
      stated += found.variance_m2 / kDraws;
    }
    const double mean = sum / kDraws, variance = squares / kDraws - mean * mean;
    // Four standard deviations of a mean and of a variance of so many draws.
    CHECK(std::abs(mean + kShift_m) < 4 * std::sqrt(variance / kDraws));
    CHECK(std::abs(variance / stated - 1) < 4 * std::sqrt(2.0 / kDraws));
    // Each cloud's points alone would give s^2 / n; that the tilts are open costs some more.
    CHECK(stated > 1.9 * kNoise_m * kNoise_m / n);
    CHECK(stated < 4 * kNoise_m * kNoise_m / n);
  }
}

TEST_CASE("add_patch__counts_its_points_and_adds_to_what_there_is") {
  PatchSums sums = patch_of(patch_points(25, 0, 0, kNoise_m, 1));
  CHECK(sums.points == 50);
  CHECK(sums.of_moving == 25);
  CHECK(sums.weights == 50);
  const PatchSums other = patch_of(patch_points(40, 0, 0, kNoise_m, 2));
  PatchSums both = sums;
  both += other;
  const RobustKernel none{KernelKind::kNone, kNoise_m};
  add_patch(patch_points(40, 0, 0, kNoise_m, 2), {0, 0, 1}, kNoise_m, none, {{}, 1}, sums);
  CHECK(sums.patches == 2);
  CHECK(sums.normal == both.normal);
  CHECK(sums.scatter == both.scatter);
  CHECK(sums.right == both.right);
  CHECK(sums.squares == both.squares);
}

TEST_CASE("add_patch__leaves_points_alone_that_fix_no_surface") {
  const auto is_left = [](const std::vector<PatchPoint>& points, double noise_m = kNoise_m) {
    const PatchSums out = patch_of(points, noise_m);
    return out.patches == 0 && out.points == 0 && out.normal == Square<6>{};
  };
  std::vector<PatchPoint> points = patch_points(20, 0, 0, kNoise_m, 3);
  CHECK_FALSE(is_left(points));
  points.resize(9);
  CHECK(is_left(points));  // ten are the least
  std::vector<PatchPoint> one_sided = patch_points(20, 0, 0, kNoise_m, 3);
  for (size_t i = 4; i < 40; ++i) one_sided[i].moving = false;
  CHECK(is_left(one_sided));  // two of the moving cloud
  one_sided[4].moving = true;
  CHECK_FALSE(is_left(one_sided));
  CHECK(is_left(patch_points(60, 0, 0, 3 * kNoise_m, 4)));  // rougher than the noise
  CHECK(is_left(patch_points(14, 0, 0.3, kNoise_m, 5)));    // bent, too few for a paraboloid
  CHECK_FALSE(is_left(patch_points(15, 0, 0.3, kNoise_m, 5)));
  std::vector<PatchPoint> line;
  for (int i = 0; i < 20; ++i) line.push_back({{0.1 * i, 0, 0}, i % 2 == 0});
  CHECK(is_left(line));
}

TEST_CASE("add_patch__a_robust_kernel_hears_no_strays") {
  std::vector<PatchPoint> points = patch_points(60, 0, 0, kNoise_m, 6);
  const Solved clean = shift_of(patch_of(points));
  points[7].place.z += 0.1;  // of the moving cloud
  const RobustKernel tukey{KernelKind::kTukey, 1.4 * kNoise_m};
  const PatchSums robust = patch_of(points, kNoise_m, tukey);
  REQUIRE(robust.patches == 1);
  CHECK(robust.points == 119);
  CHECK(std::abs(shift_of(robust).shift_m - clean.shift_m) < 2 * std::sqrt(clean.variance_m2));
}
