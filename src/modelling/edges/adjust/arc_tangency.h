// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "modelling/edges/adjust/edge_adjust.h"

namespace jalon {

/// Makes the head of a round opening touch its jambs: where two parallel lines lie on both sides of
/// an arc, its radius from its centre, within what their standard deviations and half a spacing
/// allow, arc and jambs move to the least weighted change with which they touch. Without this noise
/// decides how a jamb and its arc meet, and where: a millimetre across the tangent is five along
/// it.
///
/// Before: information is that of the arc, as adjust_edge left it. After: the arc is half a circle
/// from jamb to jamb, and the jambs' sigmas are no larger; nothing has changed where this does not
/// apply.
void touch_jambs(const EdgeInformation& information, double spacing_m, EdgeShape& before,
                 EdgeShape& arc, EdgeShape& after);

}  // namespace jalon
