// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// Numbers on the picture: the place of each against a search over all pixels.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <string>
#include <vector>

#include "base/random.h"
#include "report/pictures/label_numbers.h"

using namespace jalon;

namespace {

constexpr int kColumns = 60, kRows = 40;

// Rectangles over each other, in part noise.
LabelRaster random_rectangles(uint64_t seed) {
  RandomStream random(seed, 8);
  LabelRaster out;
  out.columns = kColumns;
  out.rows = kRows;
  out.labels.assign(size_t{kColumns} * kRows, LabelRaster::kEmpty);
  for (uint32_t label = 1; label <= 14; ++label) {
    const auto left = random.below(kColumns - 8), top = random.below(kRows - 8);
    const auto width = 3 + random.below(30), height = 3 + random.below(20);
    for (uint64_t y = top; y < std::min<uint64_t>(kRows, top + height); ++y)
      for (uint64_t x = left; x < std::min<uint64_t>(kColumns, left + width); ++x)
        out.labels[y * kColumns + x] = label % 5 == 0 ? LabelRaster::kNoise : label;
  }
  return out;
}

// Pixels, counted as a king moves, to the nearest one of another label; the raster's rim counts as such.
int room_by_search(const LabelRaster& raster, int column, int row) {
  const auto label = [&](int x, int y) {
    return raster.labels[static_cast<size_t>(y) * kColumns + static_cast<size_t>(x)];
  };
  int least = std::min({column, row, kColumns - 1 - column, kRows - 1 - row});
  for (int y = 0; y < kRows; ++y)
    for (int x = 0; x < kColumns; ++x)
      if (label(x, y) != label(column, row))
        least = std::min(least, std::max(std::abs(x - column), std::abs(y - row)));
  return least;
}

std::map<uint32_t, int> most_room(const LabelRaster& raster) {
  std::map<uint32_t, int> out;
  for (int row = 0; row < kRows; ++row)
    for (int column = 0; column < kColumns; ++column) {
      const uint32_t label =
          raster.labels[static_cast<size_t>(row) * kColumns + static_cast<size_t>(column)];
      if (label == LabelRaster::kEmpty || label == LabelRaster::kNoise) continue;
      int& most = out[label];
      most = std::max(most, room_by_search(raster, column, row));
    }
  return out;
}

}  // namespace

TEST_CASE("label_numbers__stand_where_their_segment_is_widest") {
  for (uint64_t seed = 0; seed < 4; ++seed) {
    const LabelRaster raster = random_rectangles(seed);
    const auto most = most_room(raster);
    const auto numbers = place_numbers(raster, 1e-9);  // room for any text
    CHECK(numbers.size() == most.size());
    for (const LabelNumber& n : numbers) {
      CAPTURE(n.label);
      REQUIRE(most.contains(n.label));
      CHECK(raster.labels[size_t{n.row} * kColumns + n.column] == n.label);
      CHECK(room_by_search(raster, static_cast<int>(n.column), static_cast<int>(n.row)) ==
            most.at(n.label));
    }
    CHECK(std::is_sorted(numbers.begin(), numbers.end(),
                         [](const auto& a, const auto& b) { return a.label < b.label; }));
  }
}

TEST_CASE("label_numbers__have_room_for_their_digits_or_are_left_out") {
  for (uint64_t seed = 4; seed < 8; ++seed) {
    const LabelRaster raster = random_rectangles(seed);
    const auto most = most_room(raster);
    for (const double height : {4.0, 7.0, 11.0}) {
      std::map<uint32_t, bool> has_number;
      for (const LabelNumber& n : place_numbers(raster, height)) {
        has_number[n.label] = true;
        // The text's box, digits 0.6 of its height wide, holds no pixel of another segment.
        const double digits = static_cast<double>(std::to_string(n.label).size());
        const double half_width = 0.3 * height * digits - 0.5, half_height = height / 2 - 0.5;
        size_t foreign = 0;
        for (int y = 0; y < kRows; ++y)
          for (int x = 0; x < kColumns; ++x)
            foreign += std::abs(x - static_cast<int>(n.column)) < half_width &&
                       std::abs(y - static_cast<int>(n.row)) < half_height &&
                       raster.labels[static_cast<size_t>(y * kColumns + x)] != n.label;
        CHECK(foreign == 0);
      }
      for (const auto& [label, room] : most)  // a text as high as the room to one side is small
        if (room > height) CHECK(has_number[label]);
    }
  }
}

TEST_CASE("label_numbers__of_a_segment_in_two_pieces_stands_once_on_the_larger") {
  LabelRaster raster;
  raster.columns = 40;
  raster.rows = 20;
  raster.labels.assign(800, LabelRaster::kNoise);
  for (size_t y = 5; y < 10; ++y)
    for (size_t x = 3; x < 8; ++x) raster.labels[y * 40 + x] = 7;
  for (size_t y = 5; y < 16; ++y)
    for (size_t x = 20; x < 31; ++x) raster.labels[y * 40 + x] = 7;
  const auto numbers = place_numbers(raster, 3);
  REQUIRE(numbers.size() == 1);
  CHECK(numbers[0].label == 7);
  CHECK(numbers[0].column == 25);
  CHECK(numbers[0].row == 10);
  raster.columns = 2;  // no room for anything but the rim
  raster.rows = 400;
  CHECK(place_numbers(raster, 1e-9).empty());
  CHECK(place_numbers({}, 3).empty());
}
