// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/front/side.h"

#include <cmath>

namespace jalon {

namespace {

// That much lies on either side of any wall: ghosts, noise, a plane more.
constexpr double kChance_m2 = 0.5, kReachChance_m2 = 5;

constexpr std::array<double, kFrontCues> kWeights{1.71, 1.02, 0.71, 2.26, 0.62};

double log_ratio(double a_m2, double b_m2) {
  return std::log((a_m2 + kChance_m2) / (b_m2 + kChance_m2));
}

// What lies far away says little by its mass: a room behind glass, another wing. It only says which side has it.
double share_of_both(const BothSides& sides) {
  return (sides.before - sides.behind) / (sides.before + sides.behind + kReachChance_m2);
}

}  // namespace

std::array<double, kFrontCues> front_cues(const FrontEvidence& e) {
  return {log_ratio(e.filling.behind, e.filling.before), log_ratio(e.hung.before, e.hung.behind),
          log_ratio(e.ground.before, e.ground.behind), share_of_both(e.reach),
          log_ratio(e.blocked.behind, e.blocked.before)};
}

double front_log_odds(const FrontEvidence& evidence) {
  const std::array<double, kFrontCues> cues = front_cues(evidence);
  double sum = 0;
  for (size_t i = 0; i < kFrontCues; ++i) sum += kWeights[i] * cues[i];
  return sum;
}

double probability_of(double log_odds) { return 1 / (1 + std::exp(-log_odds)); }

}  // namespace jalon
