// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

namespace jalon {

/// Of many tests the largest p-value that is called a discovery when no more than this share of discoveries is to be
/// false in the mean (Benjamini & Hochberg 1995, step up): the largest p(k) <= rate k / m. Negative where there is
/// none. rate: 0 ... 1. O(m log m).
double discovery_limit(std::vector<double> p_values, double rate);

/// Two-sided p-value of a standard normal deviate.
double normal_p_value(double z);
/// The deviate of such a p-value; infinity for one that is not positive.
double deviate_of(double p);

}  // namespace jalon
