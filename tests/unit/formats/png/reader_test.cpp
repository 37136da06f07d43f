// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include "formats/png/grid.h"
#include "unit/formats/png/small_png.h"

using namespace jalon;
using namespace jalon::test;

TEST_CASE("png__of_a_foreign_file_the_options_tell_what_pixels_are") {
  if (!png::has_libpng()) return;
  const OpenedFile file(small_png(), "a.png");
  Task task;
  ReadSettings settings;
  settings.png_source_pixel_m = 0.1;
  settings.png_step_m = 0.01;
  const Cloud cloud = read_png(file, settings, task);
  REQUIRE(cloud.size() == 3);
  CHECK(cloud.point(0) == Vec3{0.15000000000000002, 0.15000000000000002, 0.01});
  CHECK(cloud.point(2).z == doctest::Approx(0.03));
}

TEST_CASE("png__what_is_no_depth_image_is_told_so") {
  if (!png::has_libpng()) return;
  const std::string good = small_png(png::kGridKeyword, "0 0 0 1 0 0 0 -1 0 0 0 1");
  CHECK(refusal_of_png(good).status == Status::kOk);
  CHECK(refusal_of_png(small_png()).status == Status::kFormat);
  CHECK(refusal_of_png(small_png(png::kGridKeyword, "1 2")).status == Status::kFormat);
  // Every shorter file, and every file with one wrong byte, ends in a status or in points; none is a crash.
  for (size_t length = 8; length < good.size(); ++length)
    CHECK(refusal_of_png(good.substr(0, length)).status == Status::kFormat);
  size_t refused = 0;
  for (size_t at = 8; at < good.size(); ++at) {
    std::string bad = good;
    bad[at] = static_cast<char>(bad[at] ^ 0x21);
    const Status status = refusal_of_png(bad).status;
    CHECK((status == Status::kOk || status == Status::kFormat || status == Status::kUnsupported ||
           status == Status::kLimit));
    refused += status != Status::kOk;
  }
  CHECK(refused > good.size() / 2);
}
