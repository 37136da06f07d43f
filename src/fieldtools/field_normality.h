// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "base/normality.h"
#include "base/params.h"

namespace jalon {

/// The settings of operation "normality".
struct NormalitySettings {
  double alpha = 0.05;
  uint64_t most = kMostShapiroWilk;
  uint64_t seed = 1;
};
std::span<const ParamRow> normality_rows();

struct NormalityReport {
  SampleStatistics statistics;  ///< of all finite values
  ShapiroWilk test;             ///< of so many of them
  uint64_t tested = 0;
  bool is_normal = false;  ///< p above alpha: not refuted
};
/// Values that are not finite are left out; of more than settings.most that many are drawn, without
/// repetition.
NormalityReport test_normality(std::span<const double> values, const NormalitySettings& settings);

}  // namespace jalon
