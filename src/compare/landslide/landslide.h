// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "compare/comparison.h"
#include "compare/landslide/settings.h"

namespace jalon {

/// Method "landslide" (Girardeau-Montaut 2006, 5.4): the ground of both epochs cell by cell across the slope, the zones
/// that moved, and what was not measured; columns as told in jalon/comparer.h.
Comparison compare_landslide(const CloudPtr& reference, const CloudPtr& compared,
                             const LandslideSettings& settings, Task& task);

}  // namespace jalon
