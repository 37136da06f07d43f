// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "report/pictures/shown_image.h"

#include "formats/png/grey_file.h"
#include "formats/png/pictures.h"

namespace jalon {

namespace {

void draw_png(SvgWriter& svg, const Box_mm& at, const std::string& png, const char* rendering) {
  svg.leaf("image", {{"x", at.x},
                     {"y", at.y},
                     {"width", at.width},
                     {"height", at.height},
                     {"preserveAspectRatio", "none"},
                     {"style", rendering},
                     {"xlink:href", "data:image/png;base64," + base64_of(png)}});
}

}  // namespace

void draw_shown_image(SvgWriter& svg, const Box_mm& at, const IndexedImage& image) {
  if (png::has_libpng()) draw_png(svg, at, png_of(image), "image-rendering:pixelated");
}

void draw_shown_image(SvgWriter& svg, const Box_mm& at, const RgbaImage& image, Task& task) {
  if (png::has_libpng()) draw_png(svg, at, png_of(image, task), "image-rendering:auto");
}

}  // namespace jalon
