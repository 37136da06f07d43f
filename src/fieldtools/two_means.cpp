// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "fieldtools/two_means.h"

#include <cmath>
#include <limits>

#include "base/error.h"
#include "base/setting_rows.h"
#include "fieldtools/field_values.h"

namespace jalon {

namespace {

constexpr double kTwoMeansInfinity = std::numeric_limits<double>::infinity();

}  // namespace

std::span<const ParamRow> classes_rows() {
  using S = ClassesSettings;
  static constexpr auto kRows = setting_rows(
      choice_row<&S::method>("method", "two_means|thresholds", "",
                             "two_means: the cut that parts the values best into two groups; "
                             "thresholds: at low and high"),
      number_row<&S::low>("low", -1e300, 1e300, "", "thresholds",
                          "Values above it are in group 1 at least"),
      number_row<&S::high>("high", -1e300, 1e300, "", "thresholds",
                           "Values above it are in group 2; the default gives two groups"),
      string_row<&S::name>("name", "", "Name of the field of group numbers"));
  return kRows;
}

TwoMeans two_means(std::span<const double> sorted) {
  const size_t n = sorted.size();
  if (n < 2) fail(Status::kInsufficientData, "%zu values; two groups need two", n);
  // Sums from the middle value, so that large values with small differences keep their digits.
  const double origin = sorted[n / 2];
  double total = 0;
  for (const double v : sorted) total += v - origin;
  double best = -1, below = 0;
  TwoMeans out;
  for (size_t i = 1; i < n; ++i) {
    below += sorted[i - 1] - origin;
    if (!(sorted[i - 1] < sorted[i])) continue;
    const auto n0 = static_cast<double>(i), n1 = static_cast<double>(n - i);
    const double m0 = below / n0, m1 = (total - below) / n1;
    const double between =
        n0 * n1 * (m1 - m0) * (m1 - m0);  // the sum of squares within falls as this rises
    if (between <= best) continue;
    best = between;
    out = {origin + m0, origin + m1, origin + 0.5 * (m0 + m1)};
  }
  if (best < 0) fail(Status::kDegenerate, "all values are equal: they form one group");
  return out;
}

FieldClasses classify_values(std::span<const double> values, const ClassesSettings& settings,
                             Task& task) {
  FieldClasses out;
  if (settings.method == ClassesSettings::Method::kTwoMeans) {
    out.low_cut = two_means(sorted_values(finite_values(values), task)).cut;
    out.high_cut = kTwoMeansInfinity;
  } else {
    out.low_cut = settings.low;
    out.high_cut = settings.high;
    if (out.high_cut < out.low_cut) fail(Status::kInvalidArgument, "high is below low");
  }
  out.group.resize(values.size(), kNoGroup);
  double sums[3] = {0, 0, 0};
  for (size_t i = 0; i < values.size(); ++i) {
    if (!std::isfinite(values[i])) {
      ++out.missing;
      continue;
    }
    const uint8_t group = values[i] > out.high_cut ? 2 : values[i] > out.low_cut ? 1 : 0;
    out.group[i] = group;
    ++out.counts[group];
    sums[group] += values[i];
  }
  double* const centres[3] = {&out.low_centre, &out.middle_centre, &out.high_centre};
  for (size_t g = 0; g < 3; ++g) *centres[g] = sums[g] / static_cast<double>(out.counts[g]);
  return out;
}

}  // namespace jalon
