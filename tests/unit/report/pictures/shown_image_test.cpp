// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "report/pictures/shown_image.h"

#include <doctest/doctest.h>

#include "formats/png/grey_file.h"
#include "formats/png/pictures.h"
#include "unit/report/markup.h"

using namespace jalon;

TEST_CASE("shown_image__is_the_png_file_in_the_box_or_nothing_without_libpng") {
  const IndexedImage indexed{2, 1, {0, 1}, {{255, 0, 0}, {0, 0, 255}}};
  const RgbaImage rgba{1, 1, {9, 8, 7, 255}};
  Task task;
  SvgWriter svg;
  svg.open("svg", {{"xmlns:xlink", "http://www.w3.org/1999/xlink"}});
  draw_shown_image(svg, {10, 20, 30, 40}, indexed);
  draw_shown_image(svg, {1, 2, 3, 4}, rgba, task);
  svg.close();
  const std::string text = svg.take();
  CHECK(markup::well_formed(text));
  const auto has = [&](const std::string& part) { return text.find(part) != std::string::npos; };
  CHECK(has("<image") == png::has_libpng());
  if (!png::has_libpng()) return;
  CHECK(has("data:image/png;base64," + base64_of(png_of(indexed))));
  CHECK(has("data:image/png;base64," + base64_of(png_of(rgba, task))));
  CHECK(has("x=\"10\" y=\"20\" width=\"30\" height=\"40\""));
  CHECK(has("image-rendering:pixelated"));
}
