// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "compare/changes/change_features.h"

namespace jalon {

inline constexpr double kConfidenceWeights[kChangeFamilies][kChangeFeatures] = {};

}  // namespace jalon
