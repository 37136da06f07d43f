// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "compare/comparison.h"
#include "compare/distance/settings.h"

namespace jalon {

/// Distance of every compared point from the reference cloud.
Comparison compare_distance(const CloudPtr& reference, const CloudPtr& compared,
                            const DistanceSettings& settings, Task& task);

}  // namespace jalon
