// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "compare/changes/change_features.h"

namespace jalon {

/// Of each family of statements, each feature. Written by tests/accuracy/fit_changes.py, which says from what.
// clang-format off
inline constexpr double kConfidenceWeights[kChangeFamilies][kChangeFeatures] = {
    {  // came or went
        -5.1390, 0.1550, -0.0845, 0.4222, 0.1516, 0.3536, 0.5778, 0.4434,
        -0.0760, 1.7092, -4.8734, -5.4606, -0.7894, 0.8586, -0.7533, -0.8295,
        1.2576, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000,
        0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000,
        -0.2436,
    },
    {  // moved
        -2.0871, 0.0000, -0.1709, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000,
        0.0000, 0.0000, 0.0000, 0.0000, 0.1146, 0.0000, 0.0000, -0.7901,
        0.0000, -1.0922, 0.1727, -0.3455, -0.0094, 2.3023, -4.7850, -0.1134,
        -0.4910, -0.9452, 9.7295, 2.5617, 0.9397, 1.3854, -0.6370, 3.1095,
        0.0000,
    },
    {  // gave way
        -0.0645, 0.4260, -0.0651, -0.6345, -0.6374, -0.7842, -1.0271, -0.9613,
        1.1898, 1.1831, -0.9167, 1.5807, 2.1811, -1.1573, -0.6379, 1.8493,
        2.2408, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000,
        0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000, 0.0000,
        0.8003,
    },
};
// clang-format on

}  // namespace jalon
