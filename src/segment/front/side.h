// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "segment/front/evidence.h"

namespace jalon {

constexpr size_t kFrontCues = 5;
/// What each measure says for the side before the wall, in this order: filling behind, things hung before, ground
/// before, reach before, and a viewer behind blocked. All change their signs when the sides change places.
std::array<double, kFrontCues> front_cues(const FrontEvidence& evidence);

/// Logarithm of the odds that the wall was seen from before. Weights from a logistic regression without intercept
/// (Cox 1958): no side is favoured where nothing is known.
double front_log_odds(const FrontEvidence& evidence);

/// The probability that belongs to log odds.
double probability_of(double log_odds);

}  // namespace jalon
