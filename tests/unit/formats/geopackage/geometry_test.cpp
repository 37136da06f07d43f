// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// Bytes against the layout of the standard, taken apart here.
#include "formats/geopackage/geometry.h"

#include <doctest/doctest.h>

#include "formats/files/endian.h"

using namespace jalon;
using namespace jalon::gpkg;

namespace {

constexpr size_t kHeaderBytes = 8 + 4 * 8;

template <class T>
T at(const std::string& bytes, size_t offset) {
  REQUIRE(offset + sizeof(T) <= bytes.size());
  return load<T>(bytes.data() + offset);
}

}  // namespace

TEST_CASE("gpkg_geometry__a_line_has_the_header_of_its_place_and_iso_wkb") {
  const std::string bytes = line_bytes({{1, 5, 7}, {-2, 6, 8}}, 2154);
  CHECK(bytes.size() == kHeaderBytes + 9 + 2 * 24);
  CHECK(bytes.substr(0, 4) == std::string("GP\0\3", 4));
  CHECK(at<int32_t>(bytes, 4) == 2154);
  CHECK(at<double>(bytes, 8) == -2);
  CHECK(at<double>(bytes, 16) == 1);
  CHECK(at<double>(bytes, 24) == 5);
  CHECK(at<double>(bytes, 32) == 6);
  CHECK(bytes[kHeaderBytes] == 1);
  CHECK(at<uint32_t>(bytes, kHeaderBytes + 1) == 1002);
  CHECK(at<uint32_t>(bytes, kHeaderBytes + 5) == 2);
  CHECK(at<double>(bytes, kHeaderBytes + 9 + 24 + 16) == 8);
}

TEST_CASE("gpkg_geometry__rings_are_closed_and_holes_follow") {
  const Polygon polygon{{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}},
                        {{1, 1, 0}, {2, 1, 0}, {2, 2, 0}, {1, 2, 0}}};
  const std::string bytes = polygon_bytes(polygon, -1);
  CHECK(at<int32_t>(bytes, 4) == -1);
  CHECK(at<uint32_t>(bytes, kHeaderBytes + 1) == 1003);
  CHECK(at<uint32_t>(bytes, kHeaderBytes + 5) == 2);
  CHECK(at<uint32_t>(bytes, kHeaderBytes + 9) == 4);
  const size_t hole = kHeaderBytes + 13 + 4 * 24;
  CHECK(at<double>(bytes, hole - 24) == 0);  // the outline ends where it begins
  CHECK(at<uint32_t>(bytes, hole) == 5);
  CHECK(bytes.size() == hole + 4 + 5 * 24);
}

TEST_CASE("gpkg_geometry__a_mesh_is_polygons_within_one_box") {
  const std::string bytes =
      polygons_bytes({{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}, {{{5, 5, 0}, {9, 5, 0}, {5, 7, 0}}}}, 7);
  CHECK(at<double>(bytes, 8) == 0);
  CHECK(at<double>(bytes, 16) == 9);
  CHECK(at<double>(bytes, 32) == 7);
  CHECK(at<uint32_t>(bytes, kHeaderBytes + 1) == 1006);
  CHECK(at<uint32_t>(bytes, kHeaderBytes + 5) == 2);
  CHECK(bytes.size() == kHeaderBytes + 9 + 2 * (13 + 4 * 24));
}
