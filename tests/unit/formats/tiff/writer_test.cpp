// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// Depth images as GeoTIFF, taken apart by the rules of TIFF; GDAL reads them in tests/formats.
#include <doctest/doctest.h>

#include <map>

#include "unit/formats/drawings/tiff_file.h"
#include "unit/formats/opened_file.h"

using namespace jalon;
using namespace jalon::test;

namespace {

constexpr Vec3 kCorner{652000, 6861000, 100};

/// Heights 0 and 1 m in two pixels of a row, 3 m over the first one, and none in the third of four.
Cloud steps() {
  const std::vector<Vec3> points{{0.5, 0.5, 0}, {0.6, 0.4, 3}, {1.5, 0.5, 1}, {3.5, 0.5, 2}};
  Buffer<double> xyz(3 * points.size());
  for (size_t i = 0; i < points.size(); ++i)
    for (int k = 0; k < 3; ++k) xyz[3 * i + static_cast<size_t>(k)] = (kCorner + points[i])[k];
  return make_cloud(std::move(xyz));
}

Tiff tiff_of(const Cloud& cloud, const std::vector<double>& direction = {}) {
  const Folder folder;
  WriteSettings settings;
  settings.png_pixel_m = 1;
  settings.png_direction = direction;
  write(cloud, folder.file("a.tif"), settings);
  return Tiff(slurp(folder.file("a.tif")));
}

std::vector<float> numbers_of(const Tiff& tiff) {
  const std::string bytes = tiff.pixels();
  std::vector<float> out;
  for (size_t at = 0; at < bytes.size(); at += 4) out.push_back(load<float>(bytes.data() + at));
  return out;
}

std::map<uint16_t, uint16_t> keys_of(const Tiff& tiff) {
  std::map<uint16_t, uint16_t> keys;
  for (size_t k = 0; k < tiff.value<uint16_t>(34735, 3); ++k)
    keys[tiff.value<uint16_t>(34735, 4 + 4 * k)] = tiff.value<uint16_t>(34735, 7 + 4 * k);
  return keys;
}

}  // namespace

TEST_CASE("tiff__from_above_are_the_heights_of_the_highest_points_in_their_system") {
  Cloud cloud = steps();
  cloud.crs = "EPSG:2154";
  const Tiff tiff = tiff_of(cloud);
  CHECK(numbers_of(tiff) == std::vector<float>{103, 101, -9999, 102});
  CHECK(tiff.value<double>(33922, 3) == kCorner.x + 0.5);  // the first pixel's outer corner
  CHECK(tiff.value<double>(33922, 4) == kCorner.y + 1.4);
  const auto keys = keys_of(tiff);
  CHECK(keys.at(1024) == 1);
  CHECK(keys.at(3072) == 2154);
  for (const char* crs : {"", "LOCAL_CS[\"site\"]"}) {
    cloud.crs = crs;
    const auto local = keys_of(tiff_of(cloud));
    CHECK(local.at(1024) == 32767);
    CHECK(local.count(3072) == 0);
  }
}

TEST_CASE("tiff__from_the_side_on_a_national_grid_keeps_its_millimetres") {
  // Seen from the south: the depth is -y, some 6 861 km, of which float32 would lose half a metre.
  Buffer<double> xyz(6);
  for (size_t i = 0; i < 6; ++i) xyz[i] = kCorner[static_cast<int>(i % 3)];
  xyz[3] += 2;
  xyz[4] -= 0.123;
  const Tiff tiff = tiff_of(make_cloud(std::move(xyz)), {0, -1, 0});
  const std::vector<float> numbers = numbers_of(tiff);
  REQUIRE(numbers.size() == 3);
  CHECK(numbers[0] == doctest::Approx(0).epsilon(1e-6));
  CHECK(numbers[2] == doctest::Approx(0.123).epsilon(1e-5));
  CHECK(has_text(tiff.text(34737), "seen from 0 -1 0"));
  CHECK(has_text(tiff.text(34737), "values count from -6861000 m"));
}

TEST_CASE("tiff__of_no_points_is_refused") {
  const Folder folder;
  CHECK(failure_of([&] { write(Cloud{}, folder.file("a.tif")); }).status ==
        Status::kInsufficientData);
  CHECK(folder.entries() == 0);
}
