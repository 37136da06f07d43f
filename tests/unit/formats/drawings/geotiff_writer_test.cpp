// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// Files taken apart by the rules of TIFF 6.0; GDAL reads orthoimages in tests/formats.
#include "formats/drawings/geotiff_writer.h"

#include <doctest/doctest.h>

#include <cmath>
#include <map>

#include "base/random.h"
#include "formats/files/endian.h"
#include "unit/formats/drawings/tiff_file.h"

using namespace jalon;
using namespace jalon::test;

namespace {

const RasterPlace kPlace{2, 110.5, 0.25, "facade"};

}  // namespace

TEST_CASE("geotiff__numbers_come_back_and_what_is_none_is_the_no_data_value") {
  NumberImage image{3, 2, {1.5f, -0.25f, NAN, 0, 1e-7f, 3e8f}};
  Task task;
  const Tiff tiff(geotiff_of(image, kPlace, task));
  CHECK(tiff.value<uint32_t>(256) == 3);
  CHECK(tiff.value<uint32_t>(257) == 2);
  CHECK(tiff.value<uint16_t>(258) == 32);
  CHECK(tiff.value<uint16_t>(339) == 3);
  CHECK(tiff.text(42113) == std::string("-9999", 6));
  const std::string pixels = tiff.pixels();
  REQUIRE(pixels.size() == 24);
  for (size_t i = 0; i < 6; ++i)
    CHECK(load<float>(pixels.data() + 4 * i) == (i == 2 ? kNoNumber : image.pixels[i]));
}

TEST_CASE("geotiff__the_place_is_that_of_the_outer_corner_in_a_system_of_its_own_in_metres") {
  Task task;
  const Tiff tiff(geotiff_of(NumberImage{1, 1, {0}}, kPlace, task));
  CHECK(tiff.value<double>(33550, 0) == 0.25);
  CHECK(tiff.value<double>(33550, 1) == 0.25);
  CHECK(tiff.value<double>(33922, 3) == 2);
  CHECK(tiff.value<double>(33922, 4) == 110.5);
  std::map<uint16_t, uint16_t> keys;
  for (size_t k = 0; k < tiff.value<uint16_t>(34735, 3); ++k)
    keys[tiff.value<uint16_t>(34735, 4 + 4 * k)] = tiff.value<uint16_t>(34735, 7 + 4 * k);
  CHECK(keys == std::map<uint16_t, uint16_t>{{1024, 32767}, {1025, 1}, {1026, 0}, {3076, 9001}});
  CHECK(tiff.text(34737) == std::string("facade|", 8));
}

TEST_CASE("geotiff__angles_have_pixels_that_are_not_square_and_name_no_system") {
  Task task;
  const NumberImage image{2, 1, {3.5F, std::nanf("")}};
  const Tiff tiff(geotiff_of(image, AngularPlace{-10, 20, 0.5, 0.25, "angles"}, task));
  CHECK(tiff.value<double>(33550, 0) == 0.5);
  CHECK(tiff.value<double>(33550, 1) == 0.25);
  CHECK(tiff.value<double>(33922, 3) == -10);
  CHECK(tiff.value<double>(33922, 4) == 20);
  CHECK(tiff.text(270) == std::string("angles\0", 7));
  CHECK(!tiff.has(34735));
  CHECK(load<float>(tiff.pixels().data()) == 3.5F);
  CHECK(load<float>(tiff.pixels().data() + 4) == kNoNumber);
}

TEST_CASE("geotiff__colours_have_opacity_and_strips_keep_their_rows") {
  RandomStream random(1, 1);
  RgbaImage image{300, 240, std::vector<uint8_t>(4 * 300 * 240)};
  // A colour a row, and another at its end: what the test's slow inflater is done with soon.
  for (size_t i = 0; i < image.pixels.size(); ++i)
    image.pixels[i] = i % 1200 < 4 || i % 1200 > 1190 ? static_cast<uint8_t>(random.below(256))
                                                      : image.pixels[i - 4];
  Task task;
  const Tiff tiff(geotiff_of(image, kPlace, task));
  CHECK(tiff.text(258) == std::string("\x08\0\x08\0\x08\0\x08\0", 8));
  CHECK(tiff.value<uint16_t>(338) == 2);
  CHECK(tiff.value<uint16_t>(262) == 2);
  CHECK(tiff.text(273).size() == 8);  // two strips
  CHECK(!tiff.has(42113));
  std::string pixels = tiff.pixels();
  REQUIRE(pixels.size() == image.pixels.size());
  // Predictor 2: differences along the row.
  for (size_t y = 0; y < image.height; ++y)
    for (size_t i = 4; i < 1200; ++i)
      pixels[1200 * y + i] = static_cast<char>(pixels[1200 * y + i] + pixels[1200 * y + i - 4]);
  CHECK(pixels == std::string(image.pixels.begin(), image.pixels.end()));
}
