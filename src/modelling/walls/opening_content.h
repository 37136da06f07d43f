// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "modelling/walls/facade_parts.h"
#include "modelling/walls/survey.h"

namespace jalon {

/// What lies in an opening, by the points straight in it: the same with and without stations.
/// Before: opening.outline and depth_m are set; survey is of its hole, map of the wall.
OpeningContent opening_content(const HoleSurvey& survey, const WallMap& map,
                               const FacadeOpening& opening, double tolerance_m);

}  // namespace jalon
