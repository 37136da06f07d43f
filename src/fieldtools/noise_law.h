// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/field.h"
#include "base/params.h"
#include "base/task.h"

namespace jalon {

/// How deviations scatter where nothing has changed (Girardeau-Montaut 2006, 3.2.3).
enum class LawKind : uint8_t { kGauss, kWeibull, kEmpirical };  // numbers of noise_law_table

struct NoiseLaw {
  LawKind kind = LawKind::kGauss;
  double gauss_mean = 0, gauss_sigma = 1;
  double shape = 1, scale = 1, shift = 0;  ///< a, b, x0 of (3.4)
  std::vector<double> quantiles;  ///< of an empirical law: ascending, at equal steps of probability
  uint64_t samples = 0;           ///< values that it was fitted to; 0 = not known
  double sample_chi_square =
      0;  ///< distance to its own sample (3.1), the empirical cut; 0 = not known
  uint32_t sample_classes = 0;  ///< of that distance

  double density(double x) const;
  double cumulative(double x) const;  ///< P(X <= x)
  double quantile(double p) const;    ///< 0 <= p <= 1; infinite at the open ends
  double mean() const;
  double standard_deviation() const;
  /// Whether values may lie on both sides of zero: deviations then count from the mean to either side.
  bool is_signed() const;
};

/// How far values are from where there is no change, and what the law expects of that on average: tells neighbourhoods
/// that are quieter than the law from those that have changed.
struct ExpectedDeviation {
  bool two_sided = false;
  double centre = 0, mean = 0;
  double of(double x) const { return !two_sided ? x : x < centre ? centre - x : x - centre; }
};
ExpectedDeviation expected_deviation(const NoiseLaw& law);

const char* name_of(LawKind kind);  ///< "gauss", "weibull", "empirical"
std::string to_json(const NoiseLaw& law);
/// kInvalidArgument tells what is wrong.
NoiseLaw noise_law_from_json(std::string_view json);

struct NoiseLawSettings {
  enum class Law { kWeibull, kGauss, kEmpirical } law = Law::kWeibull;
  bool shift = false;    ///< of the Weibull law, estimated too
  uint32_t classes = 0;  ///< of the chi-square distance; 0: the root of the number of values
};
std::span<const ParamRow> noise_law_rows();
/// Maximum likelihood over the finite values; see jalon/field_tools.h. kInsufficientData for fewer than 9 values,
/// kDegenerate for values that do not scatter.
NoiseLaw fit_noise_law(std::span<const double> values, const NoiseLawSettings& settings,
                       Task& task);
/// One row: what is known of the law.
FieldTable noise_law_table(const NoiseLaw& law);

// The fits by themselves.
NoiseLaw fit_gauss(std::span<const double> values, Task& task);
/// Of values - shift, which must be positive but for some that are left out.
NoiseLaw fit_weibull(std::span<const double> values, double shift, Task& task);
/// The shift that is most likely (Hirose 1996), by its profile likelihood below the smallest value; 0 when the
/// likelihood has no maximum there.
double most_likely_shift(std::span<const double> sorted, Task& task);
NoiseLaw empirical_law(std::span<const double> sorted);

}  // namespace jalon
