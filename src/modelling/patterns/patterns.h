// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "modelling/walls/facade_parts.h"

namespace jalon {

/// Repeated openings (Boulaassal 2010, 5.6.3.4).
struct PatternSetting {
  bool enabled = true;
  double size_tolerance_m = 0.02;  ///< of widths and heights of one size
  double least_coverage = 0.7;     ///< share of measured outline of a well measured opening
  double least_occupancy = 0.6;    ///< share of taken crossings of a regular grid
};

/// Completes the wall's openings and returns how many copies it made; openings that become copies keep their index,
/// new ones follow. A copy has Evidence::kCopied and copied_from. Steps:
/// 1. Well measured openings of one kind, size and form are a pattern; the one of most coverage and least residual is
///    copied.
/// 2. A badly measured opening is placed by Procrustes on the border points it has, and by the pattern's rows and
///    columns where those fix only one direction.
/// 3. Crossings of the rows and columns of a regular grid where nothing was found get a copy.
/// Nothing is copied to where points of the wall lie, beside the wall, or onto another opening. Deterministic. O(n^2)
/// for n openings, besides the cells of the copies.
size_t complete_patterns(FacadeWall& wall, const PatternSetting& setting);

}  // namespace jalon
