// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "compare/changes/region_settings.h"
#include "compare/comparison.h"

namespace jalon {

/// One byte a point: 1 where the comparison, read by these settings, says that something changed.
std::vector<uint8_t> changed_points(const Comparison& comparison, const RegionSettings& settings,
                                    Task& task);

}  // namespace jalon
