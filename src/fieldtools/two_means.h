// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <vector>

#include "base/params.h"
#include "cloud/cloud.h"

namespace jalon {

/// The best split of values into two groups about their means (3.2.2, algorithm 4).
struct TwoMeans {
  double low_centre = 0, high_centre = 0,
         cut = 0;  ///< cut: half way between the centres; above it = high
};
/// The exact minimum of the sum of squares over all splits of the ascending values, by running sums: what the loop of
/// the source ends in when it starts well (= Otsu 1979 without bins). kDegenerate when all values are equal,
/// kInsufficientData below two.
TwoMeans two_means(std::span<const double> sorted);

struct ClassesSettings {
  enum class Method { kTwoMeans, kThresholds } method = Method::kTwoMeans;
  double low = 0, high = 1e300;
  std::string name = "class";
};
std::span<const ParamRow> classes_rows();

/// Groups 0, 1, 2 by up to two cuts; 255 = no value.
struct FieldClasses {
  std::vector<uint8_t> group;
  double low_cut = 0, high_cut = 0;  ///< high: infinite where there are two groups
  double low_centre = 0, middle_centre = 0, high_centre = 0;  ///< means; NaN for empty groups
  uint64_t counts[3] = {0, 0, 0};
  uint64_t missing = 0;
};
constexpr uint8_t kNoGroup = 255;
FieldClasses classify_values(std::span<const double> values, const ClassesSettings& settings,
                             Task& task);

}  // namespace jalon
