// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "spatial/raster.h"

#include <doctest/doctest.h>

#include <cmath>
#include <string>

#include "base/error.h"
#include "base/random.h"

using namespace jalon;

namespace {

/// '#' is occupied.
Raster image(const std::vector<std::string>& lines) {
  Raster raster;
  raster.columns = static_cast<uint32_t>(lines[0].size());
  raster.rows = static_cast<uint32_t>(lines.size());
  for (const std::string& line : lines)
    for (const char c : line) raster.pixels.push_back(c == '#');
  return raster;
}

Status refusal(std::span<const Vec2> points, double pixel_m) {
  try {
    rasterise(points, pixel_m);
  } catch (const Error& error) {
    return error.status();
  }
  return Status::kOk;
}

// The definition: the greatest (or least) pixel of the square, with nothing beyond the border.
Raster swept_by_definition(const Raster& in, int radius, bool grow) {
  Raster out = in;
  for (int row = 0; row < static_cast<int>(in.rows); ++row)
    for (int column = 0; column < static_cast<int>(in.columns); ++column) {
      bool any = false, all = true;
      for (int r = row - radius; r <= row + radius; ++r)
        for (int c = column - radius; c <= column + radius; ++c) {
          const bool inside =
              r >= 0 && c >= 0 && r < static_cast<int>(in.rows) && c < static_cast<int>(in.columns);
          const bool set =
              inside && in.pixels[static_cast<size_t>(r) * in.columns + static_cast<size_t>(c)];
          any |= set;
          all &= set;
        }
      out.pixels[static_cast<size_t>(row) * in.columns + static_cast<size_t>(column)] =
          grow ? any : all;
    }
  return out;
}

}  // namespace

TEST_CASE("raster__a_pixel_is_occupied_exactly_when_a_point_lies_in_it") {
  RandomStream random(3, 0);
  std::vector<Vec2> points;
  for (int i = 0; i < 60; ++i) points.push_back({10 * random.uniform(), 5 * random.uniform()});
  const uint32_t margin = 2;
  const Raster raster = rasterise(points, 0.5, margin);
  std::vector<uint8_t> expected(raster.size(), 0);
  for (const Vec2& p : points) {
    REQUIRE(raster.holds(p));
    const size_t pixel = raster.pixel_of(p);
    expected[pixel] = 1;
    const Vec2 centre = raster.centre(pixel);
    CHECK(std::abs(centre.u - p.u) <= 0.25 + 1e-12);
    CHECK(std::abs(centre.v - p.v) <= 0.25 + 1e-12);
  }
  CHECK(raster.pixels == expected);
  for (size_t i = 0; i < raster.size(); ++i) {
    const size_t column = i % raster.columns, row = i / raster.columns;
    const bool in_margin = column < margin || row < margin || column + margin >= raster.columns ||
                           row + margin >= raster.rows;
    if (in_margin) CHECK(raster.pixels[i] == 0);
  }
}

TEST_CASE("raster__points_outside_go_to_the_nearest_pixel_and_are_held_nowhere") {
  const std::vector<Vec2> points = {{0, 0}, {2.5, 1.5}};
  const Raster raster = rasterise(points, 1);
  REQUIRE(raster.columns == 3);
  REQUIRE(raster.rows == 2);
  CHECK(raster.pixel_of({-9, -9}) == 0);
  CHECK(raster.pixel_of({99, 99}) == 5);
  CHECK(raster.pixel_of({99, -9}) == 2);
  CHECK_FALSE(raster.holds({-0.1, 0.5}));
  CHECK_FALSE(raster.holds({99, 99}));
  CHECK_FALSE(raster.holds({1.5, 0.5}));
}

TEST_CASE("raster__refuses_pixels_without_size_and_images_that_are_too_large") {
  const std::vector<Vec2> points = {{0, 0}, {1e6, 1e6}};
  CHECK(refusal(points, 0) == Status::kInvalidArgument);
  CHECK(refusal(points, -1) == Status::kInvalidArgument);
  CHECK(refusal(points, std::nan("")) == Status::kInvalidArgument);
  CHECK(refusal(points, 1) == Status::kLimit);
  CHECK(rasterise({}, 1).size() == 0);
}

TEST_CASE("regions__are_numbered_by_falling_size_and_ties_by_their_first_pixel") {
  const Raster raster = image({"#..##", ".#.##", "#...."});
  const Regions eight = label_regions(raster, Connectivity2::k8);
  CHECK(eight.labels == std::vector<uint32_t>{2, 0, 0, 1, 1, 0, 2, 0, 1, 1, 2, 0, 0, 0, 0});
  CHECK(eight.pixel_counts == std::vector<uint64_t>{8, 4, 3});
  const Regions four = label_regions(raster, Connectivity2::k4);
  CHECK(four.labels == std::vector<uint32_t>{2, 0, 0, 1, 1, 0, 3, 0, 1, 1, 4, 0, 0, 0, 0});
  CHECK(four.pixel_counts == std::vector<uint64_t>{8, 4, 1, 1, 1});
}

TEST_CASE("morphology__equals_its_definition_beyond_the_border_too") {
  RandomStream random(4, 0);
  Raster raster = image(std::vector<std::string>(9, std::string(13, '.')));
  for (uint8_t& pixel : raster.pixels) pixel = random.uniform() < 0.6;
  for (const uint32_t radius : {0u, 1u, 2u, 20u}) {
    CAPTURE(radius);
    const int r = static_cast<int>(radius);
    CHECK(dilated(raster, radius).pixels == swept_by_definition(raster, r, true).pixels);
    CHECK(eroded(raster, radius).pixels == swept_by_definition(raster, r, false).pixels);
  }
}
