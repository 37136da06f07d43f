// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>

#include "base/params.h"
#include "modelling/walls/facade_parts.h"

namespace jalon {

/// Repeated openings (Boulaassal 2010, 5.6.3.4; facade-modelling A40).
struct PatternSetting {
  bool enabled = true;
  double size_tolerance_m = 0.02;
  double least_coverage = 0.7;
  double least_occupancy = 0.6;
};

/// Parameter rows of the modelling methods that complete repeated openings; a method's table joins them with its own.
inline constexpr std::array kPatternRows{
    bool_row("patterns", true, "",
             "Repeated openings: badly measured ones take the form of the best one of their kind, and one missing in a "
             "regular grid is added where no point shows a wall; both are marked as copies"),
    number_row("pattern_tolerance_m", 0.02, 0, 1, "m", "",
               "Openings whose widths and heights (full) differ by no more are of one size; more where their own "
               "standard deviations say so"),
    number_row("pattern_coverage", 0.7, 0, 1, "1", "",
               "Openings with a smaller share of measured outline are badly measured: they are no pattern and may "
               "become a copy"),
    number_row("pattern_occupancy", 0.6, 0, 1, "1", "",
               "Rows and columns make a regular grid when so large a share of their crossings that can be seen is "
               "taken"),
};
/// Reads them from a set whose table holds them.
PatternSetting pattern_setting(const ParamSet& params);

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
