// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/changes/change_confidence.h"

#include <algorithm>
#include <cmath>

namespace jalon {

namespace {

// A half at the points of two planes of the detection that share none; nine in ten at six times as many.
constexpr double kHalf_points = 64, kSteepness = 1.2;

size_t changed_of(const Epoch& epoch, const std::vector<uint32_t>& points) {
  return static_cast<size_t>(std::count_if(
      points.begin(), points.end(), [&](uint32_t i) { return epoch.regions.labels[i] != 0; }));
}

}  // namespace

double confidence_by_points(const Change& change, const Epoch& before, const Epoch& after) {
  const auto points = static_cast<double>(changed_of(before, change.object.before) +
                                          changed_of(after, change.object.after));
  if (!(points > 0)) return 0;
  return 1 / (1 + std::exp(-kSteepness * std::log(points / kHalf_points)));
}

}  // namespace jalon
