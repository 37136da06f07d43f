// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "report/pictures/picture.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <set>

#include "report/pictures/label_colours.h"
#include "report/pictures/label_numbers.h"
#include "report/pictures/label_raster.h"
#include "unit/modelling/walls.h"
#include "unit/report/markup.h"

using namespace walls;

namespace {

// A wall of 6 x 4 m with a window, and its pane 0.5 m behind; the pane is wider than the window but hidden there.
Segmentation wall_and_pane(const Vec3& shift = {}, double spacing = 0.04) {
  WallScan wall, pane;
  wall.azimuth = pane.azimuth = 0;
  wall.width = pane.width = 6;
  wall.height = pane.height = 4;
  wall.spacing = pane.spacing = spacing;
  wall.shift = pane.shift = shift;
  const Rectangle window{2, 1, 4, 3}, behind{1.5, 0.5, 4.5, 3.5};
  wall.solid = [=](double u, double v) { return !window.contains(u, v); };
  pane.solid = [=](double u, double v) { return behind.contains(u, v); };
  auto points = pane.points();
  for (Vec3& p : points) p.y += 0.5;
  return segmentation_of({wall.points(), points});
}

uint32_t label_at(const LabelRaster& raster, double u, double v) {
  const auto column = static_cast<size_t>((u - raster.low.u) / raster.pixel_m);
  const auto row = raster.rows - 1 - static_cast<size_t>((v - raster.low.v) / raster.pixel_m);
  return raster.labels[row * raster.columns + column];
}

std::string svg_of(const Segmentation& s, const char* json = "{}") {
  ParamSet options("picture", picture_rows());
  options.from_json(json);
  Task task;
  return picture_svg(s, settings_from<PictureSettings>(options), task);
}

}  // namespace

TEST_CASE("picture: the nearest segment shows, surfaces are closed, openings stay open") {
  for (const Vec3& shift : {Vec3{}, Vec3{652000, 6861000, 0}}) {
    const Segmentation s = wall_and_pane(shift);
    Task task;
    const LabelRaster raster = rasterise_labels(s, PictureView::kFront, task);
    REQUIRE(raster.labels.size() == size_t{raster.columns} * raster.rows);
    CHECK(std::fabs(raster.width_m() - 6) < 0.3);
    CHECK(std::fabs(raster.height_m() - 4) < 0.3);
    const double x = shift.x + s.T_facade_world.m[3];
    size_t wrong = 0, pixels = 0;
    for (double u = 0.1; u < 5.9; u += 0.05)
      for (double v = 0.1; v < 3.9; v += 0.05) {
        if (std::fabs(u - 2) < 0.1 || std::fabs(u - 4) < 0.1 || std::fabs(v - 1) < 0.1 ||
            std::fabs(v - 3) < 0.1)
          continue;
        ++pixels;
        wrong += label_at(raster, u + x, v) != (Rectangle{2, 1, 4, 3}.contains(u, v) ? 2u : 1u);
      }
    CAPTURE(shift.x);
    CHECK(pixels > 5000);
    CHECK(wrong == 0);
  }
}

TEST_CASE("picture: noise never hides a segment and shows beside it") {
  Segmentation s = wall_and_pane();
  auto labels = std::make_shared<Column>(FieldInfo{"label", ElementType::kUint32, 1, "", ""},
                                         s.cloud->size());
  const auto from = s.labels->values<uint32_t>();
  const auto to = labels->values<uint32_t>();
  for (size_t i = 0; i < from.size(); ++i)
    to[i] = from[i] == 1 ? 0 : from[i];  // the wall, in front, becomes noise
  s.labels = labels;
  Task task;
  const LabelRaster raster = rasterise_labels(s, PictureView::kFront, task);
  CHECK(label_at(raster, 1.7, 2) == 2);  // the pane behind it shows
  CHECK(raster.width_m() < 3.3);         // and gives the picture its size
  CHECK(std::count(raster.labels.begin(), raster.labels.end(), LabelRaster::kNoise) > 0);
}

TEST_CASE("picture: segments that meet differ in colour, for more segments than colours") {
  LabelRaster raster;
  raster.columns = raster.rows = 120;
  raster.labels.resize(size_t{120} * 120);
  for (uint32_t y = 0; y < 120; ++y)
    for (uint32_t x = 0; x < 120; ++x) raster.labels[y * 120 + x] = 1 + x / 6 + 20 * (y / 6);
  const auto colours = colour_labels(raster, 400);
  size_t equal = 0;
  for (uint32_t y = 0; y < 20; ++y)
    for (uint32_t x = 0; x < 20; ++x) {
      if (x > 0) equal += colours[y * 20 + x] == colours[y * 20 + x - 1];
      if (y > 0) equal += colours[y * 20 + x] == colours[(y - 1) * 20 + x];
    }
  CHECK(equal == 0);
  CHECK(std::set<uint8_t>(colours.begin(), colours.end()).size() == segment_palette().size());
}

TEST_CASE("picture: numbers stand inside their segments, where there is room") {
  const Segmentation s = wall_and_pane();
  Task task;
  const LabelRaster raster = rasterise_labels(s, PictureView::kFront, task);
  const auto numbers = place_numbers(raster, 5);
  REQUIRE(numbers.size() == 2);
  for (const LabelNumber& n : numbers)
    CHECK(raster.labels[size_t{n.row} * raster.columns + n.column] == n.label);
  CHECK(place_numbers(raster, 1000).empty());
}

TEST_CASE("picture: a well-formed figure with axes, legend and scale bar, also of nothing") {
  const std::string svg = svg_of(wall_and_pane(), R"({"title": "a <b> & c"})");
  CHECK(markup::well_formed(svg));
  for (const char* text :
       {"a &lt;b&gt; &amp; c: front view, 2 segments of", "Distance along the facade (m)",
        "Height Z (m)", "Segments (points)", "noise  (0)", "data:image/png;base64,"})
    CHECK_MESSAGE(svg.find(text) != std::string::npos, std::string(text));
  CHECK(svg_of(wall_and_pane(), R"({"view": "plan"})").find("plan view") != std::string::npos);
  Segmentation none = segmentation_of({});
  CHECK(markup::well_formed(svg_of(none)));
  Task task;
  CHECK(picture_png(none, {}, task).substr(1, 3) == "PNG");
}

TEST_CASE("picture: below 2 MB even when every pixel has another label") {
  const size_t n = 1200000;
  Buffer<double> xyz(3 * n);
  auto labels = std::make_shared<Column>(FieldInfo{"label", ElementType::kUint32, 1, "", ""}, n);
  RandomStream random(3, 1);
  for (size_t i = 0; i < n; ++i) {
    xyz[3 * i] = 20 * random.uniform();
    xyz[3 * i + 1] = 0;
    xyz[3 * i + 2] = 10 * random.uniform();
    labels->values<uint32_t>()[i] = static_cast<uint32_t>(1 + random.below(18));
  }
  Segmentation s = segmentation_of({});
  s.cloud = std::make_shared<const Cloud>(make_cloud(std::move(xyz)));
  s.labels = labels;
  s.segments.resize(18);
  const std::string svg = svg_of(s);
  MESSAGE("FIGURE picture of 1.2 million points, 18 labels at random: " << svg.size() << " bytes");
  CHECK(svg.size() < 2000000);
}
