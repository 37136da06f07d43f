// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "compare/comparison.h"
#include "compare/distance/settings.h"

namespace jalon {

using CompareRun = Comparison (*)(const CloudPtr& reference, const CloudPtr& compared,
                                  const DistanceSettings&, Task&);

/// Runs a method on the compared points that the stations of the reference could have seen
/// (Girardeau-Montaut 2006, algorithm 3); the others get the status of their label and no value, or
/// are recovered as the parameter "hidden" says (2.4.4): then column "recovered" tells how.
Comparison compare_visible(const CloudPtr& reference, const CloudPtr& compared,
                           const DistanceSettings& settings, CompareRun run, Task& task);

}  // namespace jalon
