// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "formats/drawings/svg_writer.h"
#include "geometry/vec.h"
#include "report/sheet/sheet.h"

namespace jalon {

/// A number or name on a picture of points, and what it is of: drawn as the convex outline of the points.
struct PictureMark {
  std::string text;
  std::vector<Vec3> points;
};

/// Outlines, and beside each its text, moved where another one stands already. place: of a point on the paper (mm);
/// within: the picture's window.
void draw_picture_marks(SvgWriter& svg, std::span<const PictureMark> marks,
                        const std::function<Vec2(const Vec3&)>& place, const Box_mm& within);

}  // namespace jalon
