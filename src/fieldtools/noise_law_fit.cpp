// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.h"
#include "base/parallel.h"
#include "base/setting_rows.h"
#include "fieldtools/chi_square.h"
#include "fieldtools/field_values.h"
#include "fieldtools/noise_law.h"

namespace jalon {

namespace {

constexpr size_t kNoiseLawFitGrain = 1 << 14;
constexpr size_t kFewestValues = 9;  // three classes of three (Saporta 1990)
constexpr size_t kMostQuantiles =
    4096;  // of an empirical law: steps far below what a neighbourhood can tell
constexpr size_t kMostForShift = 1 << 14;  // order statistics that the shift is sought with
constexpr double kLeastShape = 0.05, kMostShape = 50;

struct WeibullSums {
  double w = 0, wl = 0, wll = 0;  ///< sums of y^a, y^a ln y, y^a (ln y)^2
  WeibullSums& operator+=(const WeibullSums& b) {
    w += b.w;
    wl += b.wl;
    wll += b.wll;
    return *this;
  }
};

/// The likelihood equation of the shape: sum(y^a ln y) / sum(y^a) - 1 / a - mean(ln y) = 0, rising in a. Values are
/// taken as logarithms relative to the largest, so that no power overflows.
class ShapeEquation {
 public:
  ShapeEquation(const std::vector<double>& logs, Task& task) : logs_(logs), task_(task) {
    mean_ = mean_and_variance(logs, task).mean;
  }
  /// Safeguarded Newton steps in [0.05, 50]; false when the shape is not there.
  bool solve(double& a) {
    double low = kLeastShape, high = kMostShape;
    if (value(high).f < 0 || value(low).f > 0) return false;
    a = 1.5;
    for (int step = 0; step < 100; ++step) {
      const Step at = value(a);
      (at.f > 0 ? high : low) = a;
      double next = a - at.f / at.slope;
      if (!(next > low && next < high)) next = 0.5 * (low + high);
      const double change = std::fabs(next - a);
      a = next;
      if (change <= 1e-13 * a) break;
    }
    return true;
  }
  double mean_of_logs() const { return mean_; }
  double mean_of_powers(double a) { return sums(a).w / static_cast<double>(logs_.size()); }

 private:
  struct Step {
    double f, slope;
  };
  WeibullSums sums(double a) {
    return parallel_reduce(task_, logs_.size(), kNoiseLawFitGrain, WeibullSums{},
                           [&](size_t begin, size_t end) {
                             WeibullSums part;
                             for (size_t i = begin; i < end; ++i) {
                               const double l = logs_[i], w = std::exp(a * l);
                               part += {w, w * l, w * l * l};
                             }
                             return part;
                           });
  }
  Step value(double a) {
    const WeibullSums s = sums(a);
    const double m = s.wl / s.w;
    return {m - 1 / a - mean_, s.wll / s.w - m * m + 1 / (a * a)};
  }

  const std::vector<double>& logs_;
  Task& task_;
  double mean_;
};

struct ShiftedSample {
  std::vector<double> logs;  ///< of (value - shift) / largest
  double largest = 0;
};

/// Values at or below the shift (duplicate points: distance 0) are left out.
ShiftedSample shifted_sample(std::span<const double> values, double shift, Task& task) {
  ShiftedSample out;
  for (const double v : values) out.largest = std::max(out.largest, v - shift);
  std::vector<double> positive;
  for (const double v : values)
    if (v > shift) positive.push_back(v - shift);
  if (2 * positive.size() < values.size())
    fail(Status::kDegenerate,
         "half of the values are not above 0: no Weibull law (\"gauss\" is for signed values)");
  out.logs.resize(positive.size());
  parallel_for(task, positive.size(), kNoiseLawFitGrain, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) out.logs[i] = std::log(positive[i] / out.largest);
  });
  return out;
}

/// Mean log-likelihood at the most likely shape and scale for this shift.
double profile_likelihood(std::span<const double> sorted, double shift, Task& task) {
  const ShiftedSample sample = shifted_sample(sorted, shift, task);
  ShapeEquation equation(sample.logs, task);
  double a = 0;
  if (!equation.solve(a)) return -std::numeric_limits<double>::infinity();
  const double log_scale = std::log(equation.mean_of_powers(a)) / a;
  return std::log(a) - a * log_scale + (a - 1) * equation.mean_of_logs() - 1 -
         std::log(sample.largest);
}

/// At most this many order statistics, evenly spread.
std::vector<double> thinned(std::span<const double> sorted, size_t most) {
  const size_t n = std::min(sorted.size(), most);
  std::vector<double> out(n);
  for (size_t i = 0; i < n; ++i)
    out[i] = sorted[n == sorted.size() ? i : (2 * i + 1) * sorted.size() / (2 * n)];
  return out;
}

}  // namespace

std::span<const ParamRow> noise_law_rows() {
  using S = NoiseLawSettings;
  static constexpr auto kRows =
      setting_rows(choice_row<&S::law>("law", "weibull|gauss|empirical", "",
                                       "weibull: for distances without sign; gauss: for signed "
                                       "ones; empirical: the sample itself"),
                   bool_row<&S::shift>(
                       "shift", "", "Also estimate the shift x0 of the Weibull law; else it is 0"),
                   integer_row<&S::classes>("classes", 0, 1000, "", "",
                                            "Equally probable classes of the chi-square distance "
                                            "between law and sample; 0 = the root of the "
                                            "number of values"));
  return kRows;
}

NoiseLaw fit_gauss(std::span<const double> values, Task& task) {
  const MeanAndVariance m = mean_and_variance(values, task);
  if (!(m.variance > 0)) fail(Status::kDegenerate, "all values are equal: they have no noise law");
  NoiseLaw law;
  law.gauss_mean = m.mean;
  law.gauss_sigma = std::sqrt(m.variance);
  return law;
}

NoiseLaw fit_weibull(std::span<const double> values, double shift, Task& task) {
  const ShiftedSample sample = shifted_sample(values, shift, task);
  ShapeEquation equation(sample.logs, task);
  NoiseLaw law;
  law.kind = LawKind::kWeibull;
  if (!equation.solve(law.shape))
    fail(Status::kDegenerate,
         "the values scatter too little or too much for a Weibull law (shapes 0.05 to 50)");
  law.scale = sample.largest * std::pow(equation.mean_of_powers(law.shape), 1 / law.shape);
  law.shift = shift;
  return law;
}

double most_likely_shift(std::span<const double> sorted, Task& task) {
  const std::vector<double> sample = thinned(sorted, kMostForShift);
  const double range = sample.back() - sample.front();
  // 1. Gaps below the smallest value on a logarithmic scale: the likelihood has its maximum at some of them, and may
  // rise without bound toward the smallest value (shapes below 1).
  constexpr int kSteps = 48;
  constexpr double kLowest = -5, kHighest = 1;  // powers of ten of the range
  const auto shift_at = [&](double t) { return sample.front() - range * std::pow(10.0, t); };
  const auto likelihood = [&](double t) { return profile_likelihood(sample, shift_at(t), task); };
  std::vector<double> found(kSteps + 1);
  const double step = (kHighest - kLowest) / kSteps;
  for (int i = 0; i <= kSteps; ++i) found[static_cast<size_t>(i)] = likelihood(kLowest + i * step);
  size_t best = 0;
  for (size_t i = 1; i < kSteps; ++i)
    if (found[i] > found[i - 1] && found[i] >= found[i + 1] &&
        (best == 0 || found[i] > found[best]))
      best = i;
  if (best == 0) return 0;
  // 2. Golden section between its neighbours.
  constexpr double kGolden = 0.6180339887498949;
  double low = kLowest + (static_cast<double>(best) - 1) * step, high = low + 2 * step;
  double left = high - kGolden * (high - low), right = low + kGolden * (high - low);
  double at_left = likelihood(left), at_right = likelihood(right);
  while (high - low > 1e-6) {
    if (at_left > at_right) {
      high = right;
      right = left;
      at_right = at_left;
      at_left = likelihood(left = high - kGolden * (high - low));
    } else {
      low = left;
      left = right;
      at_left = at_right;
      at_right = likelihood(right = low + kGolden * (high - low));
    }
  }
  return shift_at(0.5 * (low + high));
}

NoiseLaw empirical_law(std::span<const double> sorted) {
  if (!(sorted.front() < sorted.back()))
    fail(Status::kDegenerate, "all values are equal: they have no noise law");
  NoiseLaw law;
  law.kind = LawKind::kEmpirical;
  const size_t n = std::min(sorted.size(), kMostQuantiles);
  law.quantiles.resize(n);
  for (size_t i = 0; i < n; ++i) law.quantiles[i] = sorted[i * (sorted.size() - 1) / (n - 1)];
  return law;
}

NoiseLaw fit_noise_law(std::span<const double> values, const NoiseLawSettings& settings,
                       Task& task) {
  const std::vector<double> known = finite_values(values);
  if (known.size() < kFewestValues)
    fail(Status::kInsufficientData, "%zu values; a noise law needs at least %zu", known.size(),
         kFewestValues);
  using Law = NoiseLawSettings::Law;
  NoiseLaw law;
  {
    ProgressSpan span(task, 0, 0.9, "fitting a noise law");
    if (settings.law == Law::kGauss) {
      law = fit_gauss(known, task);
    } else {
      const bool empirical = settings.law == Law::kEmpirical;
      const bool shifted = !empirical && settings.shift;
      const std::vector<double> sorted =
          shifted || empirical ? sorted_values(known, task) : std::vector<double>();
      law = empirical ? empirical_law(sorted)
                      : fit_weibull(known, shifted ? most_likely_shift(sorted, task) : 0, task);
    }
  }
  ProgressSpan span(task, 0.9, 1);
  law.samples = known.size();
  const ChiSquareDistance own = chi_square_distance(known, law, settings.classes, task);
  law.sample_chi_square = own.distance;
  law.sample_classes = own.classes;
  return law;
}

}  // namespace jalon
