// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// Depth images as PNG, written and read.
#include <doctest/doctest.h>

#include <cmath>

#include "unit/formats/png/small_png.h"

using namespace jalon;
using namespace jalon::test;

namespace {

// A wall of 4 x 3 m with a step of 0.2 m, a point each centimetre, seen from -y; on a national grid.
Cloud stepped_wall() {
  Buffer<double> xyz(3 * 400 * 300);
  size_t i = 0;
  for (int c = 0; c < 400; ++c)
    for (int r = 0; r < 300; ++r) {
      xyz[i++] = 652000 + 0.01 * c + 0.005;
      xyz[i++] = 6862000 + (c < 200 ? 0.0 : 0.2) + 0.00001 * r;
      xyz[i++] = 40 + 0.01 * r + 0.005;
    }
  return make_cloud(std::move(xyz));
}

WriteSettings from_the_front(PngBits bits) {
  WriteSettings settings;
  settings.png_direction = {0, -1, 0};
  settings.png_pixel_m = 0.02;
  settings.png_bits = bits;
  return settings;
}

Cloud written_and_read(const Cloud& cloud, const WriteSettings& settings) {
  const Folder folder;
  Task task;
  write_cloud(cloud, folder.file("a.png"), settings, task);
  return read_cloud(folder.file("a.png"), {}, task);
}

}  // namespace

TEST_CASE("png__a_depth_image_comes_back_within_half_a_pixel_and_half_a_grey_step") {
  if (!png::has_libpng()) return;
  const Cloud wall = stepped_wall();
  for (const PngBits bits : {PngBits::k16, PngBits::k8}) {
    const Cloud back = written_and_read(wall, from_the_front(bits));
    CHECK(back.size() == 200 * 150);
    const double half_step = 0.203 / (bits == PngBits::k16 ? 65534 : 254) / 2 + 1e-9;
    double farthest = 0;
    for (size_t i = 0; i < back.size(); ++i) {
      const Vec3 p = back.point(i);
      const double column = (p.x - 652000) / 0.02, row = (p.z - 40) / 0.02;
      CHECK(std::fabs(column - std::floor(column) - 0.25) < 0.51);
      CHECK(std::fabs(row - std::floor(row) - 0.25) < 0.51);
      // The nearest of its four points is the lowest.
      const double own = p.x < 652002 ? 0.0 : 0.2;
      const double height = std::floor((p.z - 40) / 0.02) * 0.02;
      farthest = std::max(farthest, std::fabs(p.y - 6862000 - own - 0.001 * height));
    }
    CHECK(farthest <= half_step + 2e-5);
    CHECK(back.fields.require("row").number(0, 0) == 0);
    CHECK(back.fields.require("column").number(1, 0) == 1);
  }
}

TEST_CASE("png__pixels_without_a_point_are_transparent_and_give_none") {
  if (!png::has_libpng()) return;
  Buffer<double> xyz(9);
  const double points[9] = {0, 0, 1, 1, 1, 2, 0, 0, 5};  // the third hides the first
  std::copy(points, points + 9, xyz.data());
  WriteSettings settings;
  settings.png_pixel_m = 0.5;
  const Cloud back = written_and_read(make_cloud(std::move(xyz)), settings);
  REQUIRE(back.size() == 2);
  CHECK(back.point(0).z == doctest::Approx(2).epsilon(1e-4));
  CHECK(back.point(1).z == doctest::Approx(5).epsilon(1e-4));
}

TEST_CASE("png__one_point_and_points_of_one_depth_are_images_too") {
  if (!png::has_libpng()) return;
  Buffer<double> one(3);
  one[0] = 7, one[1] = -2, one[2] = 3;
  const Cloud back = written_and_read(make_cloud(std::move(one)), {});
  REQUIRE(back.size() == 1);
  CHECK(back.point(0).z == 3);
}

TEST_CASE("png__directions_and_pixels_that_make_no_image_are_refused") {
  if (!png::has_libpng()) return;
  Task task;
  CHECK(failure_of([&] {
          WriteSettings settings;
          settings.png_direction = {0, 0, 0};
          const Folder folder;
          write_cloud(stepped_wall(), folder.file("a.png"), settings, task);
        }).status == Status::kInvalidArgument);
  CHECK(failure_of([&] {
          WriteSettings settings;
          settings.png_pixel_m = 1e-6;
          const Folder folder;
          write_cloud(stepped_wall(), folder.file("a.png"), settings, task);
        }).status == Status::kLimit);
}

TEST_CASE("png__a_library_without_libpng_names_the_package") {
  if (png::has_libpng()) return;
  const Folder folder;
  Task task;
  const Failure failure =
      failure_of([&] { write_cloud(stepped_wall(), folder.file("a.png"), {}, task); });
  CHECK(failure.status == Status::kUnsupported);
  CHECK(has_text(failure.text, "apt install libpng-dev"));
  CHECK(folder.entries() == 0);
}
