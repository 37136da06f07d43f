// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/m3c2/point_covariances.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include "base/distributions.h"
#include "base/error.h"
#include "compare/m3c2/level_of_detection.h"

namespace jalon {

namespace {

template <class T>
double along(const T* c, size_t components, const Vec3& n) {
  if (components == 9)
    return n.x * (n.x * c[0] + n.y * (double{c[1]} + c[3]) + n.z * (double{c[2]} + c[6])) +
           n.y * (n.y * c[4] + n.z * (double{c[5]} + c[7])) + n.z * n.z * c[8];
  return n.x * (n.x * c[0] + 2 * (n.y * c[1] + n.z * c[2])) + n.y * (n.y * c[3] + 2 * n.z * c[4]) +
         n.z * n.z * c[5];
}

double normal_density(double x) { return std::exp(-0.5 * x * x) / std::sqrt(2 * std::numbers::pi); }

// See PropagatedVariance. Newton's method from the harmonic mean of the sigmas, which is the answer for large n.
double common_sigma(std::span<const double> variances) {
  const auto n = static_cast<double>(variances.size());
  constexpr double kNormal95 = 1.959963984540054;
  constexpr double kMostShare = 0.45;  // below four values there is no such range
  const double share = std::min(kMostShare, 0.5 * kNormal95 / std::sqrt(n));
  double inverse = 0, positive = 0;
  for (const double v : variances) {
    if (!(v > 0)) continue;
    inverse += 1 / std::sqrt(v);
    ++positive;
  }
  if (positive == 0) return 0;
  const double standard = normal_quantile(0.5 + share);
  double d = standard * positive / inverse;
  constexpr int kMostSteps = 20;
  for (int step = 0; step < kMostSteps; ++step) {
    double excess = -share * n, slope = 0;
    for (const double v : variances) {
      const double sigma = std::sqrt(std::max(0.0, v));
      excess += sigma > 0 ? normal_cdf(d / sigma) - 0.5 : 0.5;
      if (sigma > 0) slope += normal_density(d / sigma) / sigma;
    }
    const double next = d - excess / slope;
    if (!(next > 0)) return 0;  // exact points alone hold the median
    const bool done = std::fabs(next - d) <= 1e-9 * d;
    d = next;
    if (done) break;
  }
  return d / standard;
}

}  // namespace

PointCovariances::PointCovariances(const Cloud& cloud, const char* name)
    : column_(cloud.fields.find_shared("covariance")) {
  if (!column_)
    fail(Status::kNotFound,
         "precision_from = covariances: the %s cloud has no field \"covariance\"", name);
  const FieldInfo& info = column_->info();
  if ((info.components != 6 && info.components != 9) || !is_floating(info.type))
    fail(Status::kInvalidArgument,
         "precision_from = covariances: field \"covariance\" of the %s cloud does not hold 6 or 9 "
         "floating-point "
         "numbers a point",
         name);
  components_ = info.components;
  if (info.type == ElementType::kFloat32) floats_ = column_->values<float>().data();
  else doubles_ = column_->values<double>().data();
}

double PointCovariances::variance_along(size_t point, const Vec3& normal) const {
  return floats_ != nullptr ? along(floats_ + components_ * point, components_, normal)
                            : along(doubles_ + components_ * point, components_, normal);
}

double PropagatedVariance::of_mean() const {
  const auto n = static_cast<double>(variances_.size());
  double sum = 0;
  for (const double v : variances_) sum += v;
  return sum / (n * n);
}

double PropagatedVariance::of_median() const {
  const double sigma = common_sigma(variances_);
  return variance_of_median(sigma * sigma, variances_.size());
}

}  // namespace jalon
