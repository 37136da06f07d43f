// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "fieldtools/field_normality.h"

#include <cmath>
#include <vector>

#include "base/random.h"
#include "base/setting_rows.h"

namespace jalon {

namespace {

constexpr auto kNormalityRows = setting_rows(
    number_row<&NormalitySettings::alpha>("alpha", 1e-6, 0.5, "", "",
                                          "Probability of calling a normal sample not normal."),
    integer_row<&NormalitySettings::most>(
        "most", kLeastShapiroWilk, kMostShapiroWilk, "", "",
        "Of more values than this, so many are drawn for the test; the statistics are of all."),
    integer_row<&NormalitySettings::seed>("seed", 0, 1e15, "", "", "Of that draw."));

// Selection sampling in their order (Knuth 1997, 3.4.2, algorithm S).
std::vector<double> some_of(const std::vector<double>& values, uint64_t wanted, uint64_t seed) {
  RandomStream random(seed, 0);
  std::vector<double> out;
  out.reserve(wanted);
  for (size_t i = 0; i < values.size() && out.size() < wanted; ++i)
    if (random.below(values.size() - i) < wanted - out.size()) out.push_back(values[i]);
  return out;
}

}  // namespace

std::span<const ParamRow> normality_rows() { return kNormalityRows; }

NormalityReport test_normality(std::span<const double> values, const NormalitySettings& settings) {
  std::vector<double> finite;
  for (const double v : values)
    if (std::isfinite(v)) finite.push_back(v);
  NormalityReport report;
  const std::vector<double> tested =
      finite.size() > settings.most ? some_of(finite, settings.most, settings.seed) : finite;
  report.test = shapiro_wilk(tested);
  report.tested = tested.size();
  report.is_normal = report.test.p > settings.alpha;
  report.statistics = sample_statistics(finite);
  return report;
}

}  // namespace jalon
