// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// The adjustment's cofactors in closed form and by draws; that it is the best fit is in similarity_test.cpp.

#include <doctest/doctest.h>

#include <cmath>

#include "registration/targets/adjustment.h"
#include "unit/registration/target_scenes.h"

using namespace jalon;
using namespace jalon::test;

namespace {

// Pairs that fit a motion exactly.
std::vector<TargetPair> exact_pairs(size_t n, const Transform& truth, const Square<3>& reference,
                                    const Square<3>& moving, RandomStream& random) {
  std::vector<TargetPair> out;
  for (size_t i = 0; i < n; ++i) {
    const Vec3 m = within(8, random);
    out.push_back({truth.point(m), m, reference, moving});
  }
  return out;
}

TargetAdjustment adjusted(const std::vector<TargetPair>& pairs, bool with_scale,
                          const Transform& start) {
  const AdjustedTargets out = adjust_targets(pairs, with_scale, start);
  REQUIRE(out.failure == AdjustmentFailure::kNone);
  return out.adjustment;
}

}  // namespace

TEST_CASE("adjust_targets__of_equal_weights_has_the_cofactors_of_the_closed_form") {
  RandomStream random(141, 0);
  const Transform truth = any_motion(random);
  const auto pairs = exact_pairs(7, truth, isotropic(0.003), isotropic(0.004), random);
  const Transform off = motion_about({}, {0.02, -0.01, 0.03}, {0.1, 0.2, -0.1});
  const TargetAdjustment found = adjusted(pairs, true, off * truth);
  CHECK(found.converged);
  CHECK(found.redundancy == 21 - 7);
  CHECK(found.scale == doctest::Approx(1).epsilon(1e-9));
  Square<3> levers{};
  double squares = 0;
  for (const TargetPair& p : pairs) {
    CHECK(norm(found.T_reference_moving.point(p.moving) - p.reference) < 1e-9);
    const Vec3 l = p.reference - found.centre;
    squares += squared_norm(l);
    for (int r = 0; r < 3; ++r)
      for (int c = 0; c < 3; ++c)
        levers[static_cast<size_t>(3 * r + c)] += (r == c ? squared_norm(l) : 0) - l[r] * l[c];
  }
  // 3 and 4 mm make 5 mm of a difference; about the middle turns, shifts and scale are independent.
  const double variance = 0.005 * 0.005;
  Cholesky<3> factor;
  REQUIRE(factor.factor(levers));
  const Square<3> of_turns = factor.inverse();
  for (size_t r = 0; r < 7; ++r)
    for (size_t c = 0; c < 7; ++c) {
      double expected = 0;
      if (r < 3 && c < 3) expected = variance * of_turns[3 * r + c];
      else if (r == c) expected = variance / (r < 6 ? 7 : squares);
      CHECK(std::abs(found.cofactor[7 * r + c] - expected) < 1e-6 * variance);
    }
}

TEST_CASE("adjust_targets__redundancies_of_the_pairs_sum_to_that_of_all") {
  RandomStream random(142, 0);
  const Transform truth = any_motion(random);
  for (const bool with_scale : {false, true}) {
    const auto pairs = exact_pairs(5, truth, along_ray({0, 1, 1}, 0.03, 0.01),
                                   along_ray({1, 0, 1}, 0.02, 0.005), random);
    const TargetAdjustment found = adjusted(pairs, with_scale, truth);
    double trace = 0;
    for (const PairResidual& pair : found.pairs)
      for (size_t i = 0; i < 3; ++i)
        for (size_t k = 0; k < 3; ++k) trace += pair.cofactor[3 * i + k] * pair.weight[3 * k + i];
    CHECK(found.redundancy == (with_scale ? 8 : 9));
    CHECK(trace == doctest::Approx(found.redundancy).scale(0).epsilon(1e-9));
    if (!with_scale) CHECK(found.cofactor[48] == 0);
  }
}

TEST_CASE("predicted_cofactor__is_the_scatter_of_a_pair_that_took_no_part") {
  constexpr int kDraws = 400;
  double sum = 0;
  for (uint64_t draw = 0; draw < kDraws; ++draw) {
    RandomStream random(143, draw);
    const Transform truth = any_motion(random);
    auto pairs =
        exact_pairs(6, truth, isotropic(0.004), along_ray({1, 1, 0}, 0.006, 0.002), random);
    for (TargetPair& p : pairs) {
      p.reference += noise_of(p.reference_covariance, random);
      p.moving += noise_of(p.moving_covariance, random);
    }
    const TargetPair apart = pairs.back();
    pairs.pop_back();
    const TargetAdjustment found = adjusted(pairs, false, truth);
    const Vec3 e = found.T_reference_moving.point(apart.moving) - apart.reference;
    sum += squared_length<3>(predicted_cofactor(apart, found), {e.x, e.y, e.z});
  }
  // Chi-square of 3: mean 3, variance 6.
  CHECK(std::abs(sum / kDraws - 3) < 4 * std::sqrt(6.0 / kDraws));
}

TEST_CASE("adjust_targets__says_which_pair_has_no_weight_and_that_a_line_fixes_no_turn") {
  RandomStream random(144, 0);
  const Transform truth = any_motion(random);
  auto pairs = exact_pairs(5, truth, isotropic(0.003), isotropic(0.003), random);
  pairs[3].reference_covariance = pairs[3].moving_covariance = {1e-6, 0, 0, 0, 1e-6, 0, 0, 0, 0};
  pairs[3].moving_covariance = {};
  const AdjustedTargets flat = adjust_targets(pairs, false, truth);
  CHECK(flat.failure == AdjustmentFailure::kWeights);
  CHECK(flat.wrong_pair == 3);
  pairs[3].moving_covariance = isotropic(0.001);  // the other side may be sure of what this is not
  CHECK(adjust_targets(pairs, false, truth).failure == AdjustmentFailure::kNone);
  for (size_t i = 0; i < pairs.size(); ++i) {
    const Vec3 m = Vec3{1, 2, -1} * static_cast<double>(i);
    pairs[i] = {truth.point(m), m, isotropic(0.003), isotropic(0.003)};
  }
  CHECK(adjust_targets(pairs, false, truth).failure == AdjustmentFailure::kLayout);
}
