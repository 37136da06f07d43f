// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/targets/solution.h"

#include <algorithm>
#include <cmath>

#include "base/distributions.h"
#include "base/error.h"
#include "base/text_number.h"
#include "geometry/symmetric_eigen.h"
#include "registration/similarity.h"

namespace jalon {

namespace {

constexpr double kOpenTurn_rad =
    0.1;  // standard deviation of a rotation beyond which its covariance means nothing
constexpr double kMirrorGain =
    0.01;  // share of the squares that a reflection leaves of mirrored targets
constexpr double kMirrorChance =
    1e-6;  // of residuals as large as the proper motion's by noise alone

double mean_sigma2(std::span<const TargetPair> pairs) {
  double sum = 0;
  for (const TargetPair& pair : pairs)
    for (size_t i = 0; i < 3; ++i)
      sum += pair.reference_covariance[4 * i] + pair.moving_covariance[4 * i];
  return sum / static_cast<double>(3 * pairs.size());
}

// Noise cannot tell the sides of a flat layout apart: only residuals that a reflection takes away count.
bool is_mirrored(const SimilarityFit& fit, std::span<const TargetPair> pairs) {
  if (!(fit.mirrored_squares_m2 < kMirrorGain * fit.squares_m2)) return false;
  const double squares = fit.squares_m2 / mean_sigma2(pairs);
  return chi_square_tail(static_cast<double>(3 * pairs.size()) - 6, squares) < kMirrorChance;
}

std::string on_one_line(const std::string& detail) {
  return "the targets lie on one line" + detail +
         ": the turn about it stays open; add one beside it";
}

// The largest standard deviation of a rotation about any axis.
double weakest_turn_rad(const Square<7>& cofactor) {
  const Eigen3 eigen = symmetric_eigen(
      {cofactor[0], cofactor[1], cofactor[2], cofactor[8], cofactor[9], cofactor[16]});
  return std::sqrt(std::max(0.0, eigen.values[2]));
}

std::vector<PointPair> places_of(std::span<const TargetPair> pairs) {
  std::vector<PointPair> out;
  for (const TargetPair& pair : pairs) out.push_back({pair.reference, pair.moving});
  return out;
}

// The least likely pair below the significance; pairs.size() when there is none.
size_t worst_of(const std::vector<TargetTest>& tests) {
  size_t worst = tests.size();
  for (size_t i = 0; i < tests.size(); ++i) {
    if (!tests[i].outlier) continue;
    const bool worse =
        worst == tests.size() || tests[i].p_value < tests[worst].p_value ||
        (tests[i].p_value == tests[worst].p_value && tests[i].statistic > tests[worst].statistic);
    if (worse) worst = i;
  }
  return worst;
}

TestedPair predicted(const IndexPair& pair, const TargetPair& measured,
                     const TargetAdjustment& adjustment, const Snooping& snooping) {
  const Vec3 residual = adjustment.T_reference_moving.point(measured.moving) - measured.reference;
  const Square<3> cofactor = predicted_cofactor(measured, adjustment);
  return {pair, residual, cofactor, snooping.test_prediction(residual, cofactor), true};
}

}  // namespace

std::optional<TargetAdjustment> solve_pairs(std::span<const TargetPair> pairs,
                                            const TargetSettings& setting, std::string& why) {
  why = on_one_line("");
  const std::optional<SimilarityFit> closed =
      fit_similarity(places_of(pairs), setting.with_scale());
  if (!closed) return {};
  if (is_mirrored(*closed, pairs)) {
    why =
        "the targets of one side are the mirror image of the other's: an axis has the wrong sign, "
        "or two are swapped";
    return {};
  }
  AdjustedTargets adjusted =
      adjust_targets(pairs, setting.with_scale(), closed->T_reference_moving);
  if (adjusted.failure == AdjustmentFailure::kWeights)
    fail(Status::kInvalidArgument, "pair %zu: its two covariances add up to one without an inverse",
         adjusted.wrong_pair);
  if (adjusted.failure != AdjustmentFailure::kNone) return {};
  const double turn = weakest_turn_rad(adjusted.adjustment.cofactor);
  if (turn <= kOpenTurn_rad) return std::move(adjusted.adjustment);
  why = on_one_line(" as far as their covariances tell (standard deviation of a turn: " +
                    text_of(turn, 2) + " rad)");
  return {};
}

TargetSolution solve_targets(const TargetSets& sets, std::vector<IndexPair> pairs,
                             const TargetSettings& setting, Task& task) {
  TargetSolution out;
  std::vector<IndexPair> removed;
  const auto measured = [&](std::span<const IndexPair> of) {
    return measured_pairs(sets.reference, sets.moving, of, sets.reference_origin,
                          sets.moving_origin, setting.sigma_m);
  };
  while (true) {
    task.checkpoint(0);
    if (pairs.size() < 3)
      fail(Status::kInsufficientData, "%zu targets are known on both sides; a pose needs 3",
           pairs.size());
    out.used = measured(pairs);
    std::string why;
    auto adjustment = solve_pairs(out.used, setting, why);
    if (!adjustment) fail(Status::kDegenerate, "%s", why.c_str());
    out.adjustment = std::move(*adjustment);
    const Snooping snooping(setting.snooping, out.adjustment.weighted_squares,
                            out.adjustment.redundancy);
    std::vector<TargetTest> tests;
    for (const PairResidual& pair : out.adjustment.pairs) tests.push_back(snooping.test(pair));
    const size_t worst =
        setting.remove_outliers && pairs.size() > 3 ? worst_of(tests) : tests.size();
    if (worst < tests.size()) {
      removed.push_back(pairs[worst]);
      pairs.erase(pairs.begin() + static_cast<ptrdiff_t>(worst));
      continue;
    }
    out.sigma0 = snooping.sigma0();
    for (size_t i = 0; i < pairs.size(); ++i) {
      const PairResidual& adjusted = out.adjustment.pairs[i];
      out.pairs.push_back({pairs[i], adjusted.residual_m, adjusted.cofactor, tests[i], false});
    }
    const auto apart = measured(removed);
    for (size_t i = 0; i < removed.size(); ++i)
      out.pairs.push_back(predicted(removed[i], apart[i], out.adjustment, snooping));
    out.removed = removed.size();
    return out;
  }
}

Transform placed(const Transform& T_reference_moving, const TargetSets& sets) {
  Transform out = T_reference_moving;
  const Vec3 t = T_reference_moving.translation() + sets.reference_origin -
                 T_reference_moving.direction(sets.moving_origin);
  out.m[3] = t.x;
  out.m[7] = t.y;
  out.m[11] = t.z;
  return out;
}

}  // namespace jalon
