// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "compare/comparison.h"
#include "compare/distance/settings.h"
#include "model/model.h"

namespace jalon {

/// Distance of every compared point from a model: from the faces (Girardeau-Montaut 2006, 2.2) and from the triangles
/// that stand for no face. Exact, but for the chords of arcs.
Comparison compare_with_model(const ModelPtr& reference, const CloudPtr& compared,
                              const DistanceSettings& settings, Task& task);

}  // namespace jalon
