// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "compare/changes/diagnosis.h"

namespace jalon {

/// The probability that a statement of the diagnosis by evidence is right: that the thing did change, and in the way
/// of its class, overlap or not. Logistic regression on its features.
double confidence_of(const Change& change);
/// More likely right than wrong.
bool is_told(const Change& change);

}  // namespace jalon
