// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "modelling/plane/vector_plane.h"
#include "modelling/walls/survey.h"

namespace jalon {

/// How far down the leaf that fills a notch goes on below the notch's feet (corners 0 and 1 of the outline): to where
/// its points stop for longer than the rail of a door is wide. What lies lower on the same plane is another leaf, or
/// the window of the storey below. +infinity where the leaf does not reach the feet.
///
/// notch: points in it and below it; label: of the leaf. O(n log n) for its points.
double leaf_foot(const HoleSurvey& notch, uint32_t label, const VectorRing& outline);

}  // namespace jalon
