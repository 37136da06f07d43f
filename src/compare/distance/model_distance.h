// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/params.h"
#include "compare/comparison.h"

namespace jalon {

/// Rows of method "distance" that concern models only.
constexpr ParamRow kSignedRow =
    bool_row("signed", true, "",
             "Of a model: distances are negative behind its surfaces, where their corners run clockwise.");
constexpr ParamRow kToleranceRow =
    number_row("tolerance_m", 0, 0, 1e9, "m", "",
               "Of a model: distance up to which a point is judged to be within tolerance; 0 = no judgement.");
constexpr ParamRow kChordErrorRow =
    number_row("chord_error_m", 1e-4, 1e-7, 1, "m", "",
               "Of a model: largest distance of chords from the arcs they stand for.");

/// Distance of every compared point from a model: from the faces (Girardeau-Montaut 2006, 2.2) and from the triangles
/// that stand for no face. Exact, but for the chords of arcs.
Comparison compare_with_model(const ModelPtr& reference, const CloudPtr& compared, const ParamSet& params, Task& task);

}  // namespace jalon
