// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// Pictures of distances: the same from each side, colours where the points lie, and what stands around them.
#include <doctest/doctest.h>

#include <cmath>
#include <string>
#include <vector>

#include "report/pictures/deviation_picture.h"
#include "report/pictures/label_raster.h"
#include "unit/report/markup.h"
#include "unit/report/pages/page_scenes.h"
#include "unit/report/pictures/picture_pixels.h"

using namespace jalon;

namespace {

constexpr DeviationScale kTenCentimetres{0.1, true};

// 64 x 32 points every 1/16 m, which no sum rounds: behind on the left, in front on the right, a hidden block at the
// lower left corner and one that was not compared at the upper right.
struct Sheet4 {
  std::vector<Vec3> points;
  std::vector<double> distance;
  std::vector<uint8_t> status;
  std::vector<uint32_t> labels;  ///< 1 + the step, 65 hidden, 0 without a value
};

Sheet4 sheet_of_distances() {
  Sheet4 out;
  for (int i = 0; i < 64; ++i)
    for (int j = 0; j < 32; ++j) {
      const bool is_hidden = i < 16 && j < 8, is_far = i >= 48 && j >= 24, is_left = i < 32;
      out.points.push_back({i / 16.0, j / 16.0, 0});
      out.distance.push_back(is_hidden || is_far ? NAN : is_left ? -0.1 : 0.1);
      out.status.push_back(static_cast<uint8_t>(is_hidden ? CompareStatus::kHidden
                                                : is_far  ? CompareStatus::kNothingNear
                                                          : CompareStatus::kCompared));
      out.labels.push_back(is_hidden ? 65 : is_far ? 0 : is_left ? 1 : 64);
    }
  return out;
}

Comparison comparison_on(const Sheet4& sheet, Vec3 (*place)(double, double)) {
  Comparison out;
  std::vector<Vec3> points;
  for (const Vec3& p : sheet.points) points.push_back(place(p.x, p.y));
  out.cloud = std::make_shared<const Cloud>(picture_pixels::cloud_of_points(points));
  out.points.set(make_column<double>({"distance"}, sheet.distance));
  out.points.set(make_column<uint8_t>({"status"}, sheet.status));
  return out;
}

std::string png_from(const Comparison& comparison, DeviationView view) {
  Task task;
  return deviation_png(comparison, kTenCentimetres, {.title = "", .view = view}, task);
}

std::string svg_of_distances(const Comparison& comparison, const DeviationScale& scale,
                             const DeviationPictureSettings& settings) {
  Task task;
  return deviation_svg(comparison, scale, settings, task);
}

}  // namespace

TEST_CASE("deviation_picture__is_the_same_from_above_from_the_front_and_from_the_side") {
  const Sheet4 sheet = sheet_of_distances();
  const Comparison level = comparison_on(sheet, [](double u, double v) { return Vec3{u, v, 2}; });
  const Comparison front = comparison_on(sheet, [](double u, double v) { return Vec3{u, 2, v}; });
  const Comparison side = comparison_on(sheet, [](double u, double v) { return Vec3{2, u, v}; });
  const std::string png = png_from(level, DeviationView::kPlan);
  CHECK(png_from(front, DeviationView::kFront) == png);
  CHECK(png_from(side, DeviationView::kSide) == png);
  for (const Comparison* c : {&level, &front, &side})  // auto looks along the shortest extent
    CHECK(png_from(*c, DeviationView::kAuto) == png);
  CHECK(png_from(level, DeviationView::kFront) != png);
}

TEST_CASE("deviation_picture__is_seen_from_above_and_from_the_low_end_of_the_other_axes") {
  struct Seen {
    DeviationView view;
    Vec3 (*place)(double u, double v, bool is_nearer);
  };
  const Seen seen[] = {{DeviationView::kPlan,
                        [](double u, double v, bool n) {
                          return Vec3{u, v, n ? 3.0 : 0};
                        }},
                       {DeviationView::kFront,
                        [](double u, double v, bool n) {
                          return Vec3{u, n ? 0 : 3.0, v};
                        }},
                       {DeviationView::kSide, [](double u, double v, bool n) {
                          return Vec3{n ? 0 : 3.0, u, v};
                        }}};
  for (const Seen& s : seen) {
    // Two layers behind each other: all is as if both had the distance of the nearer.
    std::vector<Vec3> points;
    std::vector<double> two, nearer;
    for (int i = 0; i < 2048; ++i) {
      points.push_back(s.place(i % 64 / 16.0, i / 64 % 16 / 16.0, i >= 1024));
      two.push_back(i >= 1024 ? -0.1 : 0.1);
      nearer.push_back(-0.1);
    }
    Comparison comparison = page_scenes::comparison_of(two);
    comparison.cloud = std::make_shared<const Cloud>(picture_pixels::cloud_of_points(points));
    const std::string png = png_from(comparison, s.view);
    comparison.points.set(make_column<double>({"distance"}, nearer));
    CHECK(png_from(comparison, s.view) == png);
  }
}

TEST_CASE("deviation_picture__points_have_the_colour_of_their_distance_or_of_why_there_is_none") {
  const Sheet4 sheet = sheet_of_distances();
  const Comparison level = comparison_on(sheet, [](double u, double v) { return Vec3{u, v, 0}; });
  Task task;
  const Projection from_above{{}, {1, 0, 0}, {0, 1, 0}, {0, 0, -1}, {}};
  const LabelRaster raster = rasterise_points(*level.cloud, sheet.labels, from_above, task);
  const auto label_in = [&](double u, double v) {
    const auto column = static_cast<size_t>((u - raster.low.u) / raster.pixel_m);
    const auto up = static_cast<size_t>((v - raster.low.v) / raster.pixel_m);
    return raster.labels[(raster.rows - 1 - up) * raster.columns + column];
  };
  REQUIRE(label_in(0.4, 0.2) == 65);
  REQUIRE(label_in(1.5, 1.5) == 1);
  REQUIRE(label_in(2.5, 0.5) == 64);
  REQUIRE(label_in(3.5, 1.75) == LabelRaster::kNoise);
  std::vector<uint8_t> pixels;  // the palette: paper, not compared, 64 steps, hidden
  for (const uint32_t label : raster.labels)
    pixels.push_back(label == LabelRaster::kEmpty   ? uint8_t{0}
                     : label == LabelRaster::kNoise ? uint8_t{1}
                                                    : static_cast<uint8_t>(label + 1));
  const std::string png = png_from(level, DeviationView::kPlan);
  CHECK(picture_pixels::has_pixels(png, raster.columns, pixels));
  const auto entry_is = [&](size_t entry, const Rgb& c) {
    return picture_pixels::palette_entry(png, entry) == std::vector<int>{c.red, c.green, c.blue};
  };
  CHECK(entry_is(0, {255, 255, 255}));
  CHECK(entry_is(1, kNotComparedColour));
  CHECK(entry_is(2, kTenCentimetres.colour(0)));
  CHECK(entry_is(65, kTenCentimetres.colour(63)));
  CHECK(entry_is(66, kHiddenColour));
}

TEST_CASE("deviation_picture__figure_names_its_axes_its_unit_and_both_ends_of_the_scale") {
  const Sheet4 sheet = sheet_of_distances();
  const Comparison level = comparison_on(sheet, [](double u, double v) { return Vec3{u, v, 0}; });
  const std::string svg = svg_of_distances(level, kTenCentimetres, {.title = "<a> & b"});
  CHECK(markup::well_formed(svg));
  for (const char* text : {"&lt;a&gt; &amp; b", ">X (m)<", ">Y (m)<", "Distance (mm)", ">-100<",
                           ">0<", ">100<", ">hidden<", ">not compared<", "image/png;base64,"})
    CHECK_MESSAGE(page_scenes::has(svg, text), text);
  const std::string side =
      svg_of_distances(level, {2, false}, {.title = "", .view = DeviationView::kSide});
  for (const char* text : {">Y (m)<", ">Z (m)<", "Distance (m)", ">0.0<", ">2.0<", ">Distances<"})
    CHECK_MESSAGE(page_scenes::has(side, text), text);
  CHECK(!page_scenes::has(side, ">-100<"));
}

TEST_CASE("deviation_picture__without_a_value_or_a_point_there_is_still_a_picture") {
  const Comparison hidden = page_scenes::comparison_of(std::vector<double>(200, NAN));
  CHECK(markup::well_formed(svg_of_distances(hidden, {}, {})));
  const Comparison none = page_scenes::comparison_of({});
  const std::string svg = svg_of_distances(none, {}, {.title = "", .view = DeviationView::kPlan});
  CHECK(markup::well_formed(svg));
  CHECK(!page_scenes::has(svg, "<image"));
  const std::string png = png_from(none, DeviationView::kPlan);
  CHECK(picture_pixels::has_pixels(png, 1, std::vector<uint8_t>{0}));  // one pixel of paper
}
