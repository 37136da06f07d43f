// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include "compare/comparison.h"
#include "formats/drawings/svg_writer.h"
#include "report/sheet/sheet.h"

namespace jalon {

/// On a picture of a comparison of method "landslide": the outlines of what went down and of what rose, and a hatching
/// over what was not measured. place: of a point on the paper (mm).
void draw_zone_lines(SvgWriter& svg, const Comparison& comparison,
                     const std::function<Vec2(const Vec3&)>& place);
/// What they mean, downward from there.
void draw_zone_key(SvgWriter& svg, double x, double y);

}  // namespace jalon
