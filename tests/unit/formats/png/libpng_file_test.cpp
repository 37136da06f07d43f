// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include "formats/png/grey_file.h"
#include "unit/formats/png/small_png.h"

using namespace jalon;
using namespace jalon::test;

TEST_CASE("libpng_file__grey_values_and_text_come_back_as_they_were_written") {
  if (!png::has_libpng()) return;
  Task task;
  for (const int bits : {8, 16}) {
    png::GreyImage image{3, 2, bits, {0, 1, 255, 7, 0, 128}};
    if (bits == 16) image.pixels[2] = 65535;
    const OpenedFile file(png::grey_png(image, "key", "some text", task), "a.png");
    png::GreyReader reader(file, "key");
    CHECK(reader.width() == 3);
    CHECK(reader.height() == 2);
    CHECK(reader.text() == "some text");
    CHECK(reader.next_row() == std::vector<int32_t>{-1, 1, bits == 16 ? 65535 : 255});
    CHECK(reader.next_row() == std::vector<int32_t>{7, -1, 128});
    CHECK_NOTHROW(reader.finish());
    CHECK(png::GreyReader(file, "another").text().empty());
  }
}

TEST_CASE("libpng_file__pictures_in_colours_are_no_depth_images") {
  if (!png::has_libpng()) return;
  // A red pixel, as any program writes it.
  const std::string red(
      "\x89\x50\x4e\x47\x0d\x0a\x1a\x0a\x00\x00\x00\x0d\x49\x48\x44\x52\x00\x00\x00\x01"
      "\x00\x00\x00\x01\x08\x02\x00\x00\x00\x90\x77\x53\xde\x00\x00\x00\x0c\x49\x44\x41"
      "\x54\x78\x9c\x63\xf8\xcf\xc0\x00\x00\x03\x01\x01\x00\xc9\xfe\x92\xef\x00\x00\x00"
      "\x00\x49\x45\x4e\x44\xae\x42\x60\x82",
      69);
  const Failure failure = refusal_of_png(red);
  CHECK(failure.status == Status::kUnsupported);
  CHECK(has_text(failure.text, "colours"));
}

TEST_CASE("libpng_file__a_cancelled_writer_stops") {
  if (!png::has_libpng()) return;
  const std::atomic<bool> cancel{true};
  Task::Hooks hooks;
  hooks.cancel = &cancel;
  Task task(hooks);
  const Failure failure = failure_of([&] {
    png::grey_png({2, 2, 8, {0, 1, 2, 3}}, "key", "text", task);
  });
  CHECK(failure.status == Status::kCancelled);
}
