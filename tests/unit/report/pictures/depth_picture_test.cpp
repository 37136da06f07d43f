// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// The picture of a depth map: greys of ranges that are known, at the pixels where the points were seen.
#include <doctest/doctest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include "base/error.h"
#include "formats/files/endian.h"
#include "report/pictures/depth_picture.h"
#include "unit/formats/files/inflated.h"
#include "unit/report/pictures/picture_pixels.h"

using namespace jalon;
using picture_pixels::has_pixels;
using picture_pixels::palette_entry;

namespace {

constexpr double kStep_rad = 0.02;

// A point in the middle of a cell: so many steps clockwise from the north and above the horizon.
Vec3 seen_at(int across, int up, double range_m) {
  const double h = kStep_rad * across, v = kStep_rad * up;
  return {range_m * std::cos(v) * std::sin(h), range_m * std::cos(v) * std::cos(h),
          range_m * std::sin(v)};
}

std::string png_of_map(const DepthMap& map) {
  Task task;
  return depth_png(map, task);
}

DepthMap map_of(const std::vector<Vec3>& points) {
  const Cloud cloud = picture_pixels::cloud_of_points(points);
  Station station;
  station.has_pose = true;
  station.count = cloud.size();
  DepthSettings settings;
  settings.horizontal_step_rad = settings.vertical_step_rad = kStep_rad;
  settings.cell_factor = 1;
  settings.fill_passes = 0;
  Task task;
  return DepthMap::build(cloud, station, {}, settings, task);
}

}  // namespace

TEST_CASE("depth_picture__greys_are_even_in_the_logarithm_and_the_highest_row_is_on_top") {
  // A frame of points at the nearest range fixes 7 columns and 5 rows; inside, quarters of the way from 2 to 50 m.
  std::vector<Vec3> points;
  std::vector<uint8_t> pixels(35, 0);
  const auto put = [&](int column, int row, double range_m, uint8_t grey) {
    points.push_back(seen_at(column - 3, row - 2, range_m));
    pixels[static_cast<size_t>((4 - row) * 7 + column)] = grey;
  };
  for (int column = 0; column < 7; ++column)
    for (int row = 0; row < 5; ++row)
      if (column % 6 == 0 || row % 4 == 0) put(column, row, 2, 255);
  put(1, 3, 50, 30);
  put(4, 1, 2 * std::pow(25.0, 0.25), 199);  // 255 - 225 / 4
  put(5, 2, 2 * std::pow(25.0, 0.75), 86);   // 255 - 3 * 225 / 4
  const DepthMap map = map_of(points);
  REQUIRE(map.grid().columns == 7);
  REQUIRE(map.grid().rows == 5);
  const std::string png = png_of_map(map);
  CHECK(has_pixels(png, 7, pixels));
  CHECK(palette_entry(png, 0) == std::vector<int>{16, 32, 72});  // dark blue where empty
  for (const int grey : {1, 30, 86, 255})
    CHECK(palette_entry(png, static_cast<size_t>(grey)) == std::vector<int>(3, grey));
  for (const char* told : {"grey 255 = 2 m", "30 = 50 m"})
    CHECK_MESSAGE(png.find(told) != std::string::npos, told);
}

TEST_CASE("depth_picture__one_range_everywhere_is_the_nearest") {
  std::vector<Vec3> points;
  for (int i = 0; i < 12; ++i) points.push_back(seen_at(i % 4, i / 4, 8));
  const DepthMap map = map_of(points);
  REQUIRE(map.grid().size() == 12);
  CHECK(has_pixels(png_of_map(map), 4, std::vector<uint8_t>(12, 255)));
  CHECK(png_of_map(map_of({{0, 3, 0}})).find("grey 255 = 3 m, 30 = 3 m") != std::string::npos);
  CHECK(has_pixels(png_of_map(map_of({{0, 3, 0}})), 1, std::vector<uint8_t>{255}));
}

TEST_CASE("depth_picture__without_a_point_is_refused") {
  for (const DepthMap& map : {DepthMap{}, map_of({})}) {
    try {
      png_of_map(map);
      CHECK(false);
    } catch (const Error& error) {
      CHECK(error.status() == Status::kInsufficientData);
      CHECK(std::string(error.what()).find("without points") != std::string::npos);
    }
  }
}

TEST_CASE("depth_picture__a_tiff_has_the_ranges_themselves_at_their_angles") {
  const DepthMap map = map_of({seen_at(3, 2, 12.5), seen_at(5, 4, 40)});
  Task task;
  const std::string tiff = depth_tiff(map, task);
  const size_t directory = load<uint32_t>(tiff.data() + 4);
  std::map<uint16_t, size_t> values;  // where those of an entry lie that are longer than the entry
  for (size_t i = 0; i < load<uint16_t>(tiff.data() + directory); ++i) {
    const char* entry = tiff.data() + directory + 2 + 12 * i;
    values[load<uint16_t>(entry)] = load<uint32_t>(entry + 8);
  }
  constexpr double kDegrees = 180 / std::numbers::pi;
  const auto number = [&](uint16_t tag, size_t i) {
    return load<double>(tiff.data() + values.at(tag) + 8 * i);
  };
  CHECK(number(33550, 0) == doctest::Approx(kStep_rad * kDegrees));
  // The middles of the corner pixels: the higher point is in the top row, the other in the left column.
  CHECK(number(33922, 3) + number(33550, 0) / 2 == doctest::Approx(3 * kStep_rad * kDegrees));
  CHECK(number(33922, 4) - number(33550, 1) / 2 == doctest::Approx(4 * kStep_rad * kDegrees));
  // Three columns, three rows, one strip: the first range stands at the lower left, the second at the upper right.
  const Inflated strip(std::string_view(tiff).substr(values.at(273), values.at(279)));
  REQUIRE(strip.ok);
  REQUIRE(strip.text.size() == 4 * 9);
  const auto range = [&](size_t pixel) { return load<float>(strip.text.data() + 4 * pixel); };
  CHECK(range(6) == doctest::Approx(12.5));
  CHECK(range(2) == doctest::Approx(40));
  for (const size_t empty : {0, 1, 3, 4, 5, 7, 8}) CHECK(range(empty) == -9999);
}
