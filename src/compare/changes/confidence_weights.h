// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "compare/changes/change_features.h"

namespace jalon {

/// Of each family of statements, each feature. Written by tests/accuracy/fit_changes.py, which says from what.
// clang-format off
inline constexpr double kConfidenceWeights[kChangeFamilies][kChangeFeatures] = {
    {  // came or went
        -8.2514, 0.3108, -0.5743, 0.5743, -0.5743, 0.4143, 1.3141, 0.8131,
        0.1594, 1.7116, -11.5900, -13.9210, 0.0000, 0.0000, 0.6982, -1.4087,
    },
    {  // moved
        23.9718, 0.7291, -0.1331, -0.4574, -0.3980, -0.5835, -0.8123, -2.0439,
        -0.9908, 0.4451, 12.8320, 1.2181, -0.0141, -11.7608, 0.0000, -0.7580,
    },
    {  // gave way
        1.9272, 1.0642, -0.3376, 1.8379, -1.5211, -1.4620, -1.6991, -1.3473,
        1.2437, 1.1126, -1.8300, -1.3232, 4.8437, -1.3264, 0.0000, 0.0188,
    },
};
// clang-format on

}  // namespace jalon
