// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/changes/change_confidence.h"

#include <cmath>
#include <numeric>

#include "compare/changes/confidence_weights.h"

namespace jalon {

double confidence_of(const Change& change) {
  const auto& weights = kConfidenceWeights[family_of(change)];
  const ChangeFeatures& features = change.features;
  const double score =
      std::inner_product(features.begin(), features.end(), std::begin(weights), 0.0);
  return 1 / (1 + std::exp(-score));
}

bool is_told(const Change& change) { return change.confidence >= 0.5; }

}  // namespace jalon
