// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "report/pictures/ortho_files.h"

#include <algorithm>
#include <limits>

#include "base/error.h"
#include "base/text_number.h"
#include "formats/drawings/geotiff_writer.h"
#include "formats/files/atomic_file.h"
#include "formats/files/utf8.h"
#include "formats/png/pictures.h"
#include "report/elevation/title_block.h"
#include "report/pictures/label_raster.h"
#include "report/pictures/picture_axes.h"
#include "report/pictures/shown_image.h"
#include "report/sheet/svg_parts.h"
#include "report/sheet/ticks.h"

namespace jalon {

namespace {

constexpr double kOrthoText = 2.5, kOrthoBarWidth = 5, kOrthoBarHeight = 46;
constexpr int kOrthoBarSteps = 64;
constexpr const char* kNoDataPaper = "#fbf3b4";  // of no scale of greys or distances

// The legend: the scale of the values, or what colours are.
void draw_key(SvgWriter& svg, const Orthoimage& image, const Sheet& sheet) {
  const double x = sheet.legend.x + 3, top = std::max(sheet.legend.y + 8, sheet.view.y + 4);
  const OrthoColours colours = colours_of(image);
  const bool in_mm = colours.is_distance && colours.high < 1;
  const char* name = image.content == OrthoContent::kColour      ? "Colour of the points"
                     : image.content == OrthoContent::kIntensity ? "Intensity"
                     : in_mm                                     ? "Before the wall (mm)"
                                                                 : "Before the wall (m)";
  svg_text(svg, {x, top - 2.5}, 2.8, Anchor::kStart, name, true);
  const auto sign = [&](double y) {
    svg.leaf("rect", {{"x", x},
                      {"y", y},
                      {"width", kOrthoBarWidth},
                      {"height", 3},
                      {"fill", kNoDataPaper},
                      {"stroke", kInk},
                      {"stroke-width", 0.18}});
    svg_text(svg, {x + kOrthoBarWidth + 2, y + 2.4}, kOrthoText, Anchor::kStart, "no data");
  };
  const std::string pixel = "pixel " + svg_number(1000 * image.pixel_m, 1) + " mm";
  if (image.content == OrthoContent::kColour || !(colours.high > colours.low)) {
    svg_text(svg, {x, top + 2}, kOrthoText, Anchor::kStart, pixel);
    return sign(top + 5);
  }
  const double step_mm = kOrthoBarHeight / kOrthoBarSteps, range = colours.high - colours.low;
  for (int step = 0; step < kOrthoBarSteps; ++step)
    svg.leaf("rect",
             {{"x", x},
              {"y", top + kOrthoBarHeight - (step + 1) * step_mm},
              {"width", kOrthoBarWidth},
              {"height", step_mm + 0.05},
              {"fill", hex_of(colours(colours.low + range * (step + 0.5) / kOrthoBarSteps))}});
  svg.leaf("rect", {{"x", x},
                    {"y", top},
                    {"width", kOrthoBarWidth},
                    {"height", kOrthoBarHeight},
                    {"fill", "none"},
                    {"stroke", kInk},
                    {"stroke-width", 0.2}});
  const double factor = in_mm ? 1000 : 1;
  const Ticks ticks = make_ticks(factor * colours.low, factor * colours.high, factor * range / 8);
  for (const double value : ticks.values) {
    const double y = top + kOrthoBarHeight * (1 - (value / factor - colours.low) / range);
    svg_line(svg, {x + kOrthoBarWidth, y}, {x + kOrthoBarWidth + 1.2, y}, kInk, 0.18);
    svg_text(svg, {x + kOrthoBarWidth + 2, y + 0.9}, kOrthoText, Anchor::kStart,
             ticks.label(value));
  }
  svg_text(svg, {x, top + kOrthoBarHeight + 6}, kOrthoText, Anchor::kStart, pixel);
  sign(top + kOrthoBarHeight + 9);
}

}  // namespace

std::string orthoimage_png(const Orthoimage& image, Task& task) {
  return png_of(rgba_of(image), task);
}

std::string orthoimage_world(const Orthoimage& image) {
  const double half_m = image.pixel_m / 2;
  std::string out;
  for (const double value :
       {image.pixel_m, 0.0, 0.0, -image.pixel_m, image.left_m + half_m, image.top_m - half_m})
    out += text_of(value) + "\n";
  return out;
}

std::string orthoimage_tiff(const Orthoimage& image, Task& task) {
  const RasterPlace place{image.left_m, image.top_m, image.pixel_m,
                          "facade elevation: x along the facade, y the height, in metres"};
  if (image.content == OrthoContent::kColour) return geotiff_of(rgba_of(image), place, task);
  NumberImage numbers{image.columns, image.rows, image.values};
  for (size_t i = 0; i < image.size(); ++i)
    if (image.has_data[i] == 0) numbers.pixels[i] = std::numeric_limits<float>::quiet_NaN();
  return geotiff_of(numbers, place, task);
}

void write_orthoimage(const Cloud& cloud, const Model& model, const OrthoimageSettings& settings,
                      const std::string& path, Task& task) {
  const std::string end = lower(path.substr(path.size() - std::min<size_t>(path.size(), 5)));
  const bool is_tiff = end.ends_with(".tif") || end.ends_with(".tiff");
  if (!is_tiff && !end.ends_with(".png"))
    fail(Status::kUnsupported, "%.400s: orthoimages are written as png, tif or tiff", path.c_str());
  AtomicFile file(path);
  if (is_tiff) {
    file.write(
        orthoimage_tiff(make_orthoimage(cloud, model, settings, kMostOrthoPixels, task), task));
    return file.commit();
  }
  AtomicFile world(path.substr(0, path.size() - 3) + "pgw");
  const Orthoimage image = make_orthoimage(cloud, model, settings, kMostOrthoPixels, task);
  file.write(orthoimage_png(image, task));
  world.write(orthoimage_world(image));
  world.commit();
  file.commit();
}

std::string orthoimage_svg(const Orthoimage& image, const std::string& title, Task& task) {
  LabelRaster raster;  // its place alone, for the axes
  raster.columns = image.columns;
  raster.rows = image.rows;
  raster.pixel_m = image.pixel_m;
  raster.low = {image.left_m, image.top_m - image.rows * image.pixel_m};
  const Sheet sheet = lay_out_figure(raster.width_m(), raster.height_m());
  const Box_mm& v = sheet.view;
  SvgWriter svg;
  open_figure(svg, sheet, title);
  svg_text(svg, {v.x, v.y - 3.5}, 3.2, Anchor::kStart,
           fitted_text(title, 3.2, sheet.width - v.x - 3), true);
  svg.leaf(
      "rect",
      {{"x", v.x}, {"y", v.y}, {"width", v.width}, {"height", v.height}, {"fill", kNoDataPaper}});
  draw_shown_image(svg, v, rgba_of(image), task);
  svg.leaf("rect", {{"x", v.x},
                    {"y", v.y},
                    {"width", v.width},
                    {"height", v.height},
                    {"fill", "none"},
                    {"stroke", kInk},
                    {"stroke-width", 0.25}});
  draw_axes(svg, raster, sheet,
            {"Distance along the facade (m)", "Height Z (m)", image.facade.left_m, 12, kOrthoText});
  draw_key(svg, image, sheet);
  draw_scale_bar(svg, sheet);
  return svg.take();
}

}  // namespace jalon
