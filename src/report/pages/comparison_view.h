// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/task.h"
#include "compare/comparison.h"
#include "report/pictures/deviation_colours.h"
#include "report/viewer/scene.h"

namespace jalon {

/// Both clouds of a comparison in the colours of their distances on the report's scale, the reference hidden at
/// first; the regions or changes by number at their centroids. reverse may be null.
ViewScene comparison_scene(const Comparison& forward, const Comparison* reverse,
                           const FieldTable& changes, const DeviationScale& scale);

}  // namespace jalon
