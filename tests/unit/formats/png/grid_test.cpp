// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/png/grid.h"

#include <doctest/doctest.h>

#include "unit/formats/opened_file.h"

using namespace jalon;
using namespace jalon::png;
using namespace jalon::test;

TEST_CASE("png_grid__its_text_gives_the_same_bits_back_and_nothing_else_is_one") {
  const DepthGrid grid{{6.5e5, 6.8e6 + 0.1, 1.0 / 3}, {0.01, 1e-300, 0}, {0, -0.01, 0}, {0, 0, 2}};
  DepthGrid back;
  REQUIRE(parse_grid(text_of_grid(grid), back));
  CHECK(back.origin == grid.origin);
  CHECK(back.right == grid.right);
  CHECK(back.down == grid.down);
  CHECK(back.toward == grid.toward);
  CHECK(back.point(3, 2, 5).z == grid.origin.z + 10);
  for (const char* text : {"", "1 2 3", "1 2 3 4 5 6 7 8 9 10 11 inf", "1 2 3 4 5 6 7 8 9 10 11 x",
                           "1 2 3 4 5 6 7 8 9 10 11 12 13"})
    CHECK_FALSE(parse_grid(text, back));
}

TEST_CASE("png_grid__of_a_file_is_its_own_then_that_of_its_world_file_then_of_the_options") {
  const Folder folder;
  spill(folder.file("a.png"), "any");
  const ByteSource source(folder.file("a.png"));
  ReadSettings settings;
  const auto refused = [&](const std::string& text) {
    const Failure failure = failure_of([&] { grid_of_file(source, text, 10, settings); });
    CHECK(failure.status == Status::kFormat);
    return failure.text;
  };
  CHECK(has_text(refused(""), "png_step_m"));
  settings.png_step_m = 0.001;
  CHECK(has_text(refused(""), "png_source_pixel_m"));
  CHECK(has_text(refused("1 2"), "twelve numbers"));
  settings.png_source_pixel_m = 0.5;
  settings.png_zero_m = 7;
  const DepthGrid plain = grid_of_file(source, "", 10, settings);
  CHECK(plain.point(0, 9, 0) == Vec3{0.25, 0.25, 7});
  CHECK(plain.point(1, 0, 1000).x == 0.75);
  CHECK(plain.point(1, 0, 1000).y == 4.75);
  CHECK(plain.point(1, 0, 1000).z == doctest::Approx(8));
  spill(folder.file("a.pgw"), "0.2\n0\n0\n-0.2\n100\n200\n");
  const DepthGrid world = grid_of_file(source, "", 10, settings);
  CHECK(world.point(0, 0, 0) == Vec3{100, 200, 7});
  CHECK(world.point(10, 5, 0).x == doctest::Approx(102));
  CHECK(world.point(10, 5, 0).y == doctest::Approx(199));
  spill(folder.file("a.pgw"), "0.2 0 0\n");
  CHECK(has_text(refused(""), "six numbers"));
  const DepthGrid own = grid_of_file(source, text_of_grid(plain), 10, settings);
  CHECK(own.origin == plain.origin);
}
