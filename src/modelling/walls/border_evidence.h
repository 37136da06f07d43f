// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "modelling/walls/facade_parts.h"
#include "modelling/walls/survey.h"

namespace jalon {

/// Sets coverage, residual_m and border_points of an opening from the wall's points beside it and
/// the map: the outline is walked in steps of a cell, but for the upper edge of a sill; a step is
/// covered where a point of the wall lies just outside and nothing in front hides the inside.
///
/// Before: wall.map is set; survey is that of the opening's hole. After: border_points lie outside
/// the outline, within a few spacings of it.
void measure_border(const FacadeWall& wall, const HoleSurvey& survey, FacadeOpening& opening);

}  // namespace jalon
