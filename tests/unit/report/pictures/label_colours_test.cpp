// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// Colours of segments: a search over all pairs of near pixels, and what the picture's palette says.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <vector>

#include "base/random.h"
#include "report/pictures/label_colours.h"

using namespace jalon;

namespace {

LabelRaster raster_sized(uint32_t columns, uint32_t rows) {
  LabelRaster out;
  out.columns = columns;
  out.rows = rows;
  out.labels.assign(size_t{columns} * rows, LabelRaster::kEmpty);
  return out;
}

// Cells of the nearest of random sites, with gaps of two pixels and more where the borders are.
LabelRaster random_cells(uint32_t side, uint32_t sites, uint64_t seed) {
  RandomStream random(seed, 6);
  std::vector<double> x, y;
  for (uint32_t i = 0; i < sites; ++i) {
    x.push_back(side * random.uniform());
    y.push_back(side * random.uniform());
  }
  LabelRaster out = raster_sized(side, side);
  for (uint32_t row = 0; row < side; ++row)
    for (uint32_t column = 0; column < side; ++column) {
      double least = 1e9, second = 1e9;
      uint32_t best = 0;
      for (uint32_t i = 0; i < sites; ++i) {
        const double d = std::hypot(column - x[i], row - y[i]);
        if (d < least) best = i;
        second = std::min(second, std::max(d, least));
        least = std::min(least, d);
      }
      if (second - least > 1.5) out.labels[size_t{row} * side + column] = best + 1;
    }
  return out;
}

}  // namespace

TEST_CASE("label_colours__segments_with_a_narrow_gap_between_them_differ") {
  for (uint64_t seed = 0; seed < 5; ++seed) {
    const LabelRaster raster = random_cells(80, 50, seed);
    const auto colours = colour_labels(raster, 50);
    REQUIRE(colours.size() == 50);
    size_t met = 0, alike = 0;
    for (size_t at = 0; at < raster.labels.size(); ++at)
      for (size_t apart = 1; apart <= 3; ++apart)
        for (const size_t step : {apart, apart * 80}) {
          const size_t other = at + step;
          if (other >= raster.labels.size() || (step < 80 && at / 80 != other / 80)) continue;
          const uint32_t a = raster.labels[at], b = raster.labels[other];
          if (a == b || a == LabelRaster::kEmpty || b == LabelRaster::kEmpty) continue;
          ++met;
          alike += colours[a - 1] == colours[b - 1];
        }
    CAPTURE(seed);
    CHECK(met > 100);  // across gaps: no two cells touch
    CHECK(alike == 0);
  }
}

TEST_CASE("label_colours__a_wall_has_its_colour_for_itself") {
  // Label 1 is a wall; 60 spots far from it and from each other must share the other colours, evenly.
  LabelRaster raster = raster_sized(200, 60);
  for (size_t row = 0; row < 60; ++row)
    for (size_t column = 0; column < 80; ++column) raster.labels[row * 200 + column] = 1;
  for (uint32_t spot = 0; spot < 60; ++spot)
    raster.labels[size_t{5 + 9 * (spot / 11)} * 200 + 90 + 9 * (spot % 11)] = spot + 2;
  const auto colours = colour_labels(raster, 61);
  std::vector<int> used(segment_palette().size(), 0);
  for (size_t i = 1; i < colours.size(); ++i) {
    CHECK(colours[i] != colours[0]);
    ++used[colours[i]];
  }
  used.erase(used.begin() + colours[0]);
  CHECK(*std::max_element(used.begin(), used.end()) - *std::min_element(used.begin(), used.end()) <=
        1);
  CHECK(colour_labels(raster, 61) == colours);  // the same picture, the same colours
  CHECK(colour_labels(raster_sized(0, 0), 0).empty());
}

TEST_CASE("label_colours__each_pixel_shows_the_colour_of_its_segment_noise_or_paper") {
  LabelRaster raster = raster_sized(4, 2);
  raster.labels = {1, 2, LabelRaster::kNoise, LabelRaster::kEmpty, 3, 3, LabelRaster::kNoise, 1};
  const std::vector<uint8_t> colours{5, 0, 17};
  const IndexedImage image = image_of(raster, colours);
  CHECK(image.width == 4);
  CHECK(image.height == 2);
  REQUIRE(image.pixels.size() == 8);
  for (size_t i = 0; i < 8; ++i) {
    const uint32_t label = raster.labels[i];
    const Rgb truth = label == LabelRaster::kEmpty   ? kPaperColour
                      : label == LabelRaster::kNoise ? kNoiseColour
                                                     : segment_palette()[colours[label - 1]];
    REQUIRE(image.pixels[i] < image.palette.size());
    CHECK(image.palette[image.pixels[i]] == truth);
  }
  const auto palette = segment_palette();
  for (size_t i = 0; i < palette.size(); ++i) {
    CHECK(palette[i] != kPaperColour);
    CHECK(palette[i] != kNoiseColour);
    for (size_t k = 0; k < i; ++k) {  // colours that a reader tells apart: 30 code values at least
      const int apart = std::abs(palette[i].red - palette[k].red) +
                        std::abs(palette[i].green - palette[k].green) +
                        std::abs(palette[i].blue - palette[k].blue);
      CHECK(apart >= 30);
    }
  }
}
