// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cloud/cloud.h"
#include "compare/comparison.h"
#include "compare/m3c2/settings.h"

namespace jalon {

/// Multiscale model to model cloud comparison (Lague, Brodu & Leroux 2013): at each core point the distance between the
/// two clouds along the local normal, compared minus reference, with its level of detection. The core points are
/// taken from one of the clouds.
Comparison compare_m3c2(const CloudPtr& reference, const CloudPtr& compared,
                        const M3c2Settings& settings, Task& task);
/// The same at given core points.
Comparison compare_m3c2_core(const CloudPtr& reference, const CloudPtr& compared,
                             const CloudPtr& core, const M3c2Settings& settings, Task& task);

}  // namespace jalon
