// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "formats/drawings/pixels.h"
#include "formats/drawings/svg_writer.h"
#include "report/sheet/sheet.h"

namespace jalon {

/// The picture over all of this box, inside the drawing. A library without libpng leaves it out: axes, legend and
/// numbers still tell.
void draw_shown_image(SvgWriter& svg, const Box_mm& at, const IndexedImage& image);
/// In true colour, which is smoothed where it is enlarged.
void draw_shown_image(SvgWriter& svg, const Box_mm& at, const RgbaImage& image, Task& task);

}  // namespace jalon
