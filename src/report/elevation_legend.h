// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "report/elevation.h"
#include "report/svg_parts.h"

namespace jalon {

// What stands around the drawing.

void draw_legend(SvgWriter& svg, const ElevationFaces& faces, const Sheet& sheet);
void draw_scale_bar(SvgWriter& svg, const Sheet& sheet);
void draw_title_block(SvgWriter& svg, const ElevationFaces& faces, const Sheet& sheet, const ElevationSetting& setting);

}  // namespace jalon
