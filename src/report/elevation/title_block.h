// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "report/elevation/elevation.h"
#include "report/sheet/svg_parts.h"

namespace jalon {

void draw_scale_bar(SvgWriter& svg, const Sheet& sheet);
/// With a plan of the view: north, the facade's line and the eye's direction.
void draw_title_block(SvgWriter& svg, const ElevationDrawing& drawing);

}  // namespace jalon
