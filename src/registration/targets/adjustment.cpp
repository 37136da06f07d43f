// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/targets/adjustment.h"

#include <cmath>
#include <optional>

#include "geometry/rigid_motion.h"

namespace jalon {

namespace {

constexpr int kMostAdjustments = 100;  // three or four are usual
constexpr double kSmallAdjustment =
    1e-8;  // in standard deviations of the unknowns: far below anything that matters

template <size_t K>
using Design = std::array<double, 3 * K>;  // row-major, 3 x K

Square<3> rotated(const Transform& T, const Square<3>& covariance) {
  const auto& m = T.m;
  return propagated<3, 3>({m[0], m[1], m[2], m[4], m[5], m[6], m[8], m[9], m[10]}, covariance);
}

Vec3 times_of_adjustment(const Square<3>& m, const Vec3& v) {
  return {m[0] * v.x + m[1] * v.y + m[2] * v.z, m[3] * v.x + m[4] * v.y + m[5] * v.z,
          m[6] * v.x + m[7] * v.y + m[8] * v.z};
}

// Of T(m) - r: C_r + T C_m T^T.
Square<3> misclosure_covariance(const TargetPair& pair, const Transform& T_reference_moving) {
  Square<3> sum = rotated(T_reference_moving, pair.moving_covariance);
  for (size_t i = 0; i < 9; ++i) sum[i] += pair.reference_covariance[i];
  return sum;
}

// Derivatives of T(m) by rotation and shift of the centre and by the logarithm of the scale.
template <size_t K>
Design<K> design_at(const Vec3& lever) {
  Design<K> a{};
  const double turn[9] = {0, lever.z, -lever.y, -lever.z, 0, lever.x, lever.y, -lever.x, 0};
  for (size_t r = 0; r < 3; ++r) {
    for (size_t c = 0; c < 3; ++c) a[K * r + c] = turn[3 * r + c];
    a[K * r + 3 + r] = 1;
    if constexpr (K == 7) a[K * r + 6] = lever[static_cast<int>(r)];
  }
  return a;
}

template <size_t K>
class Adjuster {
 public:
  Adjuster(std::span<const TargetPair> pairs, const Transform& T_start)
      : pairs_(pairs), T_reference_moving_(T_start) {
    for (const TargetPair& pair : pairs) centre_moving_ += pair.moving - pairs[0].moving;
    centre_moving_ = pairs[0].moving + centre_moving_ / static_cast<double>(pairs.size());
    rows_.resize(pairs.size());
  }

  AdjustedTargets run() {
    AdjustedTargets result;
    TargetAdjustment& out = result.adjustment;
    for (int step = 0; step < kMostAdjustments && !out.converged; ++step) {
      // 1. Normal equations at the present pose.
      if (!normal_equations(result)) return result;
      // 2. Their solution, and its length in standard deviations.
      const Coefficients<K> x = factor_.solve(right_);
      double length2 = 0;
      for (size_t i = 0; i < K; ++i) length2 += x[i] * right_[i];
      if (!std::isfinite(length2)) {
        result.failure = AdjustmentFailure::kLayout;
        return result;
      }
      out.steps.push_back({squares_, std::sqrt(std::max(0.0, length2))});
      // 3. The step.
      move(x);
      out.converged = out.steps.back().step < kSmallAdjustment;
    }
    // 4. Residuals and cofactors at the last pose.
    if (normal_equations(result)) write(out);
    return result;
  }

 private:
  struct Row {
    Vec3 residual;
    Square<3> covariance, weight;
    Design<K> design;
  };

  // Sums and factor of the normal equations; false, and says why, where they have no solution.
  bool normal_equations(AdjustedTargets& result) {
    if (const std::optional<size_t> wrong = linearise()) {
      result.wrong_pair = *wrong;
      result.failure = AdjustmentFailure::kWeights;
    } else if (!factor_.factor(normal_)) {
      result.failure = AdjustmentFailure::kLayout;
    }
    return result.failure == AdjustmentFailure::kNone;
  }

  // Misclosures at the measured places, derivatives at the adjusted ones; sums of the normal
  // equations. Gives the pair that has no weight, if any.
  std::optional<size_t> linearise() {
    normal_ = {};
    right_ = {};
    squares_ = 0;
    const Vec3 centre = T_reference_moving_.point(centre_moving_);
    for (size_t i = 0; i < pairs_.size(); ++i) {
      Row& row = rows_[i];
      const TargetPair& pair = pairs_[i];
      row.residual = T_reference_moving_.point(pair.moving) - pair.reference;
      row.covariance = misclosure_covariance(pair, T_reference_moving_);
      Cholesky<3> factor;
      if (!factor.factor(row.covariance)) return i;
      row.weight = factor.inverse();
      const Vec3 correlates = times_of_adjustment(row.weight, row.residual);
      const Vec3 corrected =
          times_of_adjustment(rotated(T_reference_moving_, pair.moving_covariance), correlates);
      const Vec3 adjusted = T_reference_moving_.point(pair.moving) - corrected;
      row.design = design_at<K>(adjusted - centre);
      squares_ += dot(row.residual, correlates);
      add(row, correlates);
    }
    return std::nullopt;
  }

  void add(const Row& row, const Vec3& correlates) {
    for (size_t c = 0; c < K; ++c) {
      const Vec3 column{row.design[c], row.design[K + c], row.design[2 * K + c]};
      const Vec3 weighted = times_of_adjustment(row.weight, column);
      right_[c] -= dot(column, correlates);
      for (size_t d = 0; d < K; ++d)
        normal_[K * d + c] +=
            dot(Vec3{row.design[d], row.design[K + d], row.design[2 * K + d]}, weighted);
    }
  }

  void move(const Coefficients<K>& x) {
    const Vec3 centre = T_reference_moving_.point(centre_moving_);
    double grown = 1;
    if constexpr (K == 7) grown = std::exp(x[6]);
    Transform linear = rotation_by({x[0], x[1], x[2]}) * T_reference_moving_;
    for (double& m : linear.m) m *= grown;
    const Vec3 t = centre + Vec3{x[3], x[4], x[5]} - linear.direction(centre_moving_);
    linear.m[3] = t.x;
    linear.m[7] = t.y;
    linear.m[11] = t.z;
    T_reference_moving_ = linear;
  }

  void write(TargetAdjustment& out) const {
    out.T_reference_moving = T_reference_moving_;
    out.scale = K == 7 ? std::cbrt(T_reference_moving_.determinant()) : 1;
    out.centre = T_reference_moving_.point(centre_moving_);
    const Square<K> inverse = factor_.inverse();
    for (size_t r = 0; r < K; ++r)
      for (size_t c = 0; c < K; ++c) out.cofactor[7 * r + c] = inverse[K * r + c];
    out.weighted_squares = squares_;
    out.redundancy = static_cast<int>(3 * pairs_.size()) - static_cast<int>(K);
    out.pairs.clear();
    for (const Row& row : rows_) {
      PairResidual pair{row.residual, row.weight, row.covariance};
      const Square<3> explained = propagated<3, K>(row.design, inverse);
      for (size_t i = 0; i < 9; ++i) pair.cofactor[i] -= explained[i];
      out.pairs.push_back(pair);
    }
  }

  std::span<const TargetPair> pairs_;
  Transform T_reference_moving_;
  Vec3 centre_moving_;
  std::vector<Row> rows_;
  Square<K> normal_{};
  Coefficients<K> right_{};
  double squares_ = 0;
  Cholesky<K> factor_;
};

}  // namespace

AdjustedTargets adjust_targets(std::span<const TargetPair> pairs, bool with_scale,
                               const Transform& T_start) {
  return with_scale ? Adjuster<7>(pairs, T_start).run() : Adjuster<6>(pairs, T_start).run();
}

Square<3> predicted_cofactor(const TargetPair& pair, const TargetAdjustment& adjustment) {
  Square<3> sum = misclosure_covariance(pair, adjustment.T_reference_moving);
  const Vec3 place = adjustment.T_reference_moving.point(pair.moving);
  const Design<7> design = design_at<7>(place - adjustment.centre);
  const Square<3> of_pose = propagated<3, 7>(design, adjustment.cofactor);
  for (size_t i = 0; i < 9; ++i) sum[i] += of_pose[i];
  return sum;
}

}  // namespace jalon
