// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "base/numbers.h"
#include "base/parallel.h"
#include "geometry/cholesky.h"

namespace jalon {

/// Adjustment of a curved surface to points by least squares or by Tukey's biweight.
///
/// A Model has `Point`, `kUnknowns`, `double residual(const Point&, Coefficients<kUnknowns>&
/// derivatives) const`, the signed
/// distance, and `void move(const Coefficients<kUnknowns>& step)`, a small change of the unknowns.
struct AdjustSetting {
  double reach_m = INFINITY;  ///< points further away have no say
  bool robust = true;         ///< biweight; else every point within reach has weight 1
};

template <size_t K>
struct Adjusted {
  uint64_t n = 0;          ///< points with a weight
  double sigma = 0;        ///< standard deviation of the distances, outliers taken off
  Square<K> covariance{};  ///< of the unknowns
};

namespace adjustment {

constexpr int kMaxSteps = 50;           // Boulaassal 2010, E.1.1, which sets none
constexpr double kSmallStep = 1e-10;    // same source
constexpr double kBiweightCut = 4.685;  // 95 % efficiency for normal noise (Huber & Ronchetti 2009)
constexpr double kMadToSigma = 1.4826;  // median of |x| of the standard normal, inverted
constexpr double kScaleCut = 3;         // sigma comes from the distances within 3 sigma ...
constexpr double kScaleVariance = 0.973337;  // ... whose variance is 1 - 6 phi(3) / (2 Phi(3) - 1)
constexpr double kLeastSigma_m = 1e-9;       // keeps noise-free points from having no weight
constexpr size_t kFewPoints = 30;  // below, weights from the points' own scatter mean nothing
constexpr size_t kMaxScaleSample = 1 << 16;
constexpr size_t kPointsPerChunk = 1 << 13;
constexpr double kFirstDamping = 1e-3, kDampingFactor = 10, kMaxDamping = 1e12;

/// psi, its derivative, the weight psi / d and the loss of one distance.
struct Influence {
  double psi = 0, slope = 0, weight = 0, loss = 0;
};

struct Weighting {
  double reach_m, cut_m;  ///< cut_m: infinity for least squares
  bool least_squares() const { return !(cut_m < INFINITY); }
  Influence operator()(double d) const {
    if (!(std::fabs(d) <= reach_m))
      return {0, 0, 0, least_squares() ? reach_m * reach_m / 2 : cut_m * cut_m / 6};
    if (least_squares()) return {d, 1, 1, d * d / 2};
    const double u = d / cut_m, v = 1 - u * u;
    if (v <= 0) return {0, 0, 0, cut_m * cut_m / 6};
    return {d * v * v, v * (1 - 5 * u * u), v * v, cut_m * cut_m / 6 * (1 - v * v * v)};
  }
};

template <size_t K>
struct Sums {
  Square<K> normal{}, slopes{}, squares{};  ///< sums of j j^T with the weights w, psi', psi^2
  Coefficients<K> right{};
  double loss = 0, psi2 = 0, slope = 0, slope2 = 0;
  uint64_t n = 0;
  Sums& operator+=(const Sums& b) {
    for (size_t i = 0; i < K * K; ++i) {
      normal[i] += b.normal[i];
      slopes[i] += b.slopes[i];
      squares[i] += b.squares[i];
    }
    for (size_t i = 0; i < K; ++i) right[i] += b.right[i];
    loss += b.loss;
    psi2 += b.psi2;
    slope += b.slope;
    slope2 += b.slope2;
    n += b.n;
    return *this;
  }
  void add(const Influence& f, const Coefficients<K>& j, bool with_covariance) {
    loss += f.loss;
    if (f.weight == 0) return;
    ++n;
    psi2 += f.psi * f.psi;
    slope += f.slope;
    slope2 += f.slope * f.slope;
    for (size_t r = 0; r < K; ++r) {
      right[r] -= f.psi * j[r];
      for (size_t c = 0; c < K; ++c) normal[K * r + c] += f.weight * j[r] * j[c];
    }
    if (!with_covariance) return;
    for (size_t r = 0; r < K; ++r)
      for (size_t c = 0; c < K; ++c) {
        slopes[K * r + c] += f.slope * j[r] * j[c];
        squares[K * r + c] += f.psi * f.psi * j[r] * j[c];
      }
  }
};

template <class Model>
Sums<Model::kUnknowns> sums_of(std::span<const typename Model::Point> points, const Model& model,
                               const Weighting& weighting, bool with_covariance, Task& task) {
  using S = Sums<Model::kUnknowns>;
  return parallel_reduce(task, points.size(), kPointsPerChunk, S{}, [&](size_t begin, size_t end) {
    S part;
    Coefficients<Model::kUnknowns> j;
    for (size_t i = begin; i < end; ++i) {
      const double d = model.residual(points[i], j);
      part.add(weighting(d), j, with_covariance);
    }
    return part;
  });
}

template <class Model>
double distance_of(const Model& model, const typename Model::Point& p) {
  Coefficients<Model::kUnknowns> unused;
  return model.residual(p, unused);
}

/// Scale of the distances within reach by their median, from an even sample.
template <class Model>
double median_scale(std::span<const typename Model::Point> points, const Model& model,
                    double reach_m) {
  const size_t step = points.size() / kMaxScaleSample + 1;
  std::vector<double> far;
  for (size_t i = 0; i < points.size(); i += step) {
    const double d = std::fabs(distance_of(model, points[i]));
    if (d <= reach_m) far.push_back(d);
  }
  if (far.empty()) return 0;
  const auto middle = far.begin() + static_cast<ptrdiff_t>(far.size() / 2);
  std::nth_element(far.begin(), middle, far.end());
  return kMadToSigma * *middle;
}

struct Scatter {
  double squares = 0;
  uint64_t n = 0;
  Scatter& operator+=(const Scatter& b) {
    squares += b.squares;
    n += b.n;
    return *this;
  }
};

/// Standard deviation of the distances within 3 of the present one, corrected for what lies beyond.
template <class Model>
double trimmed_scale(std::span<const typename Model::Point> points, const Model& model,
                     double sigma_m, double reach_m, Task& task) {
  const double cut = std::min(reach_m, kScaleCut * std::max(sigma_m, kLeastSigma_m));
  const Scatter s = parallel_reduce(task, points.size(), kPointsPerChunk, Scatter{},
                                    [&](size_t begin, size_t end) {
                                      Scatter part;
                                      for (size_t i = begin; i < end; ++i) {
                                        const double d = distance_of(model, points[i]);
                                        if (std::fabs(d) <= cut) part += {d * d, 1};
                                      }
                                      return part;
                                    });
  if (s.n <= Model::kUnknowns) return sigma_m;
  return std::sqrt(s.squares / static_cast<double>(s.n - Model::kUnknowns) / kScaleVariance);
}

template <size_t K>
bool is_below(const Coefficients<K>& change, const Coefficients<K>& small) {
  for (size_t i = 0; i < K; ++i)
    if (!(std::fabs(change[i]) <= small[i])) return false;
  return true;
}

/// Gauss-Newton with the damping of Levenberg and Marquardt until a step is below `small`, in each unknown's own
/// unit; false when an unknown is not fixed or the steps are used up.
template <class Model>
bool descend(std::span<const typename Model::Point> points, const Weighting& weighting, int steps,
             const Coefficients<Model::kUnknowns>& small, Task& task, Model& model) {
  constexpr size_t kK = Model::kUnknowns;
  double damping = kFirstDamping;
  Sums<kK> here = sums_of(points, model, weighting, false, task);
  for (int step = 0; step < steps;) {
    if (here.n < kK) return false;
    Square<kK> normal = here.normal;
    for (size_t i = 0; i < kK; ++i) normal[kK * i + i] *= 1 + damping;
    Cholesky<kK> factor;
    if (!factor.factor(normal)) return false;
    const Coefficients<kK> change = factor.solve(here.right);
    for (const double c : change)
      if (!std::isfinite(c)) return false;
    const bool is_small = is_below<kK>(change, small);
    Model next = model;
    next.move(change);
    const Sums<kK> there = sums_of(points, next, weighting, false, task);
    ++step;
    if (there.loss <= here.loss) {
      model = next;
      here = there;
      damping /= kDampingFactor;
    } else if (!is_small) {
      damping *= kDampingFactor;
    }
    if (is_small) return true;
    if (damping > kMaxDamping) return false;
  }
  return false;
}

/// The same with one bound for all unknowns, where metres and radians are alike.
template <class Model>
bool descend(std::span<const typename Model::Point> points, const Weighting& weighting, int steps,
             double small, Task& task, Model& model) {
  Coefficients<Model::kUnknowns> all;
  all.fill(small);
  return descend(points, weighting, steps, all, task, model);
}

/// Huber (1981), 6.5: the sandwich psi'^-1 psi^2 psi'^-1, honest when the noise differs from point to point, as it does
/// where a beam grazes the surface. Without weights sigma^2 (J^T J)^-1.
template <size_t K>
bool covariance_of(const Sums<K>& sums, bool least_squares, Square<K>& out) {
  Cholesky<K> factor;
  if (!factor.factor(least_squares ? sums.normal : sums.slopes)) return false;
  const double n = static_cast<double>(sums.n), freedom = n - static_cast<double>(K);
  out = factor.inverse();
  if (!(freedom > 0)) {
    out.fill(kNaN);
  } else if (least_squares) {
    for (double& c : out) c *= sums.psi2 / freedom;
  } else {
    const double mean = sums.slope / n, spread = sums.slope2 / n / (mean * mean) - 1;
    const double small_sample = 1 + static_cast<double>(K) / n * spread;  // Huber (1981), 7.6
    out = sandwich<K>(out, sums.squares);
    for (double& c : out) c *= small_sample * small_sample * n / freedom;
  }
  return true;
}

}  // namespace adjustment

/// From a start to the adjusted surface: 1. sigma of the points and a step, in turns; 2. steps until they are below
/// 1e-10 with sigma kept; 3. covariance. False when the points do not fix the surface; the model is then undefined.
template <class Model>
bool adjust(std::span<const typename Model::Point> points, const AdjustSetting& setting, Task& task,
            Model& model, Adjusted<Model::kUnknowns>& out) {
  using namespace adjustment;
  constexpr int kTurns = 30;
  constexpr double kSettled = 1e-3;  // change of sigma, relative, that ends the turns
  const bool robust = setting.robust && points.size() >= kFewPoints;
  Weighting weighting{setting.reach_m, INFINITY};
  double sigma = 0;
  if (robust) {
    sigma = median_scale(points, model, setting.reach_m);
    for (int turn = 0; turn < kTurns; ++turn) {
      weighting.cut_m = kBiweightCut * std::max(sigma, kLeastSigma_m);
      descend(points, weighting, 2, kSmallStep, task, model);
      const double before = sigma;
      sigma = turn < 3 ? median_scale(points, model, setting.reach_m)
                       : trimmed_scale(points, model, sigma, setting.reach_m, task);
      if (turn > 3 && std::fabs(sigma - before) <= kSettled * sigma) break;
    }
    weighting.cut_m = kBiweightCut * std::max(sigma, kLeastSigma_m);
  }
  if (!descend(points, weighting, kMaxSteps, kSmallStep, task, model)) return false;
  const auto sums = sums_of(points, model, weighting, true, task);
  if (sums.n < Model::kUnknowns || !covariance_of(sums, !robust, out.covariance)) return false;
  out.n = sums.n;
  const uint64_t freedom = sums.n - Model::kUnknowns;
  out.sigma = robust        ? sigma
              : freedom > 0 ? std::sqrt(sums.psi2 / static_cast<double>(freedom))
                            : 0;
  return true;
}

}  // namespace jalon
