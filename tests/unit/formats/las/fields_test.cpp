// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// The places of the dimensions against the tables of ASPRS LAS 1.4 R15, and against each other: a record is tiled.
#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "base/field.h"
#include "formats/las/fields.h"

using namespace jalon;

namespace {

const las::Dimension* dimension_named(const std::vector<las::Dimension>& all,
                                      const std::string& name) {
  for (const las::Dimension& dimension : all)
    if (dimension.field.name == name) return &dimension;
  return nullptr;
}

int offset_of(unsigned format, const std::string& name) {
  const std::vector<las::Dimension> all = las::dimensions(format);
  const las::Dimension* found = dimension_named(all, name);
  return found == nullptr ? -1 : found->place.offset;
}

}  // namespace

TEST_CASE("las_fields__every_bit_behind_the_coordinates_belongs_to_exactly_one_dimension") {
  for (unsigned format = 0; format <= 10; ++format) {
    CAPTURE(format);
    std::vector<int> owners(8 * size_t{las::point_format(format)->bytes}, 0);
    for (size_t bit = 0; bit < 96; ++bit) owners[bit] = 1;  // X, Y, Z
    for (const las::Dimension& dimension : las::dimensions(format)) {
      const las::Place& place = dimension.place;
      const size_t first = 8 * static_cast<size_t>(place.offset) + static_cast<size_t>(place.shift);
      const size_t bits =
          place.bits != 0 ? static_cast<size_t>(place.bits) : 8 * size_of(place.type);
      REQUIRE(first + bits <= owners.size());
      for (size_t bit = first; bit < first + bits; ++bit) ++owners[bit];
    }
    for (size_t bit = 0; bit < owners.size(); ++bit) {
      CAPTURE(bit);
      CHECK(owners[bit] == 1);
    }
  }
}

TEST_CASE("las_fields__offsets_are_those_of_the_tables_and_absent_dimensions_are_not_listed") {
  // Tables 7-17: of formats 0 to 10.
  constexpr int kGps[] = {-1, 20, -1, 20, 20, 20, 22, 22, 22, 22, 22};
  constexpr int kRed[] = {-1, -1, 20, 28, -1, 28, -1, 30, 30, -1, 30};
  constexpr int kNir[] = {-1, -1, -1, -1, -1, -1, -1, -1, 36, -1, 36};
  constexpr int kWave[] = {-1, -1, -1, -1, 28, 34, -1, -1, -1, 30, 38};
  for (unsigned format = 0; format <= 10; ++format) {
    CAPTURE(format);
    CHECK(offset_of(format, "gps_time") == kGps[format]);
    CHECK(offset_of(format, "red") == kRed[format]);
    CHECK(offset_of(format, "blue") == (kRed[format] < 0 ? -1 : kRed[format] + 4));
    CHECK(offset_of(format, "nir") == kNir[format]);
    CHECK(offset_of(format, "wavepacket_index") == kWave[format]);
    CHECK(offset_of(format, "z_t") == (kWave[format] < 0 ? -1 : kWave[format] + 25));
    CHECK(offset_of(format, "classification") == (format < 6 ? 15 : 16));
    CHECK(offset_of(format, "point_source_id") == (format < 6 ? 18 : 20));
    CHECK(offset_of(format, "overlap") == (format < 6 ? -1 : 15));
  }
}

TEST_CASE("las_fields__bits_grow_with_the_newer_formats_and_dimensions_stand_in_order") {
  const auto bits = [](unsigned format, const char* name) {
    const std::vector<las::Dimension> all = las::dimensions(format);
    return dimension_named(all, name)->place.bits;
  };
  CHECK(bits(0, "return_number") == 3);  // 1 to 5 returns
  CHECK(bits(6, "return_number") == 4);  // 1 to 15
  CHECK(bits(0, "classification") == 5);
  CHECK(bits(6, "classification") == 0);  // a byte
  for (unsigned format = 0; format <= 10; ++format) {
    CAPTURE(format);
    int last = -1;
    for (const las::Dimension& dimension : las::dimensions(format)) {
      const int at = 8 * dimension.place.offset + dimension.place.shift;
      CHECK_MESSAGE(at > last, dimension.field.name);
      last = at;
    }
  }
}
