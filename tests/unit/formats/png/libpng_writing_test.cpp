// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// Pictures, taken apart by the standard; grey ones are read back in libpng_file_test.cpp.
#include <doctest/doctest.h>

#include "base/error.h"
#include "base/random.h"
#include "formats/png/grey_file.h"
#include "formats/png/pictures.h"
#include "unit/formats/fixtures.h"
#include "unit/formats/png/png_chunks.h"

using namespace jalon;
using namespace jalon::test;

namespace {

IndexedImage random_image(uint32_t width, uint32_t height, size_t colours) {
  RandomStream random(width, height);
  IndexedImage image{width, height, {}, {}};
  for (size_t i = 0; i < size_t{width} * height; ++i)
    image.pixels.push_back(static_cast<uint8_t>(random.below(colours)));
  for (size_t i = 0; i < colours; ++i)
    image.palette.push_back({static_cast<uint8_t>(i), static_cast<uint8_t>(random.below(256)), 7});
  return image;
}

std::string text_of_bytes(const std::vector<uint8_t>& bytes) {
  return {bytes.begin(), bytes.end()};
}

}  // namespace

TEST_CASE("libpng_writing__pixels_and_palette_of_a_picture_of_few_colours_come_back") {
  if (!png::has_libpng()) return;
  for (const auto& [width, height] :
       {std::pair(1u, 1u), std::pair(300u, 5u), std::pair(2u, 1000u), std::pair(257u, 300u)}) {
    const IndexedImage image = random_image(width, height, 256);
    const PngChunks chunks(png_of(image));
    CHECK(chunks.names == "IHDRPLTEIDATIEND");
    CHECK(chunks.width() == width);
    CHECK(chunks.height() == height);
    CHECK(chunks.content("IHDR").substr(8) == std::string("\x08\x03\0\0\0", 5));
    std::string palette;
    for (const Rgb& c : image.palette)
      palette += {static_cast<char>(c.red), static_cast<char>(c.green), static_cast<char>(c.blue)};
    CHECK(chunks.content("PLTE") == palette);
    CHECK(chunks.pixels(1) == text_of_bytes(image.pixels));
  }
}

TEST_CASE("libpng_writing__a_description_stands_before_the_pixels_and_changes_nothing_else") {
  if (!png::has_libpng()) return;
  IndexedImage image = random_image(7, 5, 3);
  const PngChunks without(png_of(image));
  image.description = "distances, blue to red";
  const PngChunks with(png_of(image));
  CHECK(with.names == "IHDRPLTEtEXtIDATIEND");
  CHECK(with.content("tEXt") == std::string("Description") + '\0' + image.description);
  for (const char* type : {"IHDR", "PLTE", "IDAT"})
    CHECK(with.content(type) == without.content(type));
}

TEST_CASE("libpng_writing__true_colour_comes_back_with_its_opacity_and_even_areas_take_little") {
  if (!png::has_libpng()) return;
  RandomStream random(3, 1);
  RgbaImage image{61, 40, std::vector<uint8_t>(4 * 61 * 40)};
  for (uint8_t& sample : image.pixels) sample = static_cast<uint8_t>(random.below(256));
  Task task;
  const PngChunks chunks(png_of(image, task));
  CHECK(chunks.names == "IHDRIDATIEND");
  CHECK(chunks.content("IHDR").substr(8) == std::string("\x08\x06\0\0\0", 5));
  CHECK(chunks.pixels(4) == text_of_bytes(image.pixels));
  const RgbaImage even{1000, 1000, std::vector<uint8_t>(4000000, 200)};
  CHECK(png_of(even, task).size() < 8000);
}

TEST_CASE("libpng_writing__a_cancelled_picture_stops") {
  if (!png::has_libpng()) return;
  const std::atomic<bool> cancel{true};
  Task::Hooks hooks;
  hooks.cancel = &cancel;
  Task task(hooks);
  const RgbaImage image{2, 2, std::vector<uint8_t>(16, 1)};
  CHECK(failure_of([&] { png_of(image, task); }).status == Status::kCancelled);
}
