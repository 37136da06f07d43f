// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// PCD put together by hand: three encodings of one cloud are one cloud; what the header says.
#include <doctest/doctest.h>

#include <bit>
#include <cmath>
#include <limits>

#include "formats/files/endian.h"
#include "formats/pcd/header.h"
#include "formats/pcd/pcd.h"
#include "unit/formats/opened_file.h"

using namespace jalon;
using namespace jalon::test;

namespace {

Cloud pcd_cloud(const std::string& bytes, bool drop_invalid = false) {
  const OpenedFile file(bytes, "a.pcd");
  Task task;
  ReadSettings settings;
  settings.drop_invalid = drop_invalid;
  return read_pcd(file, settings, task);
}

std::string refused_pcd(const std::string& bytes) {
  const Failure failure = failure_of([&] { pcd_cloud(bytes); });
  CHECK(failure.status == Status::kFormat);
  return failure.text;
}

const std::string kMixed =
    "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\n"
    "FIELDS x y z _ rgb ring normal_x normal_y normal_z hist\nSIZE 4 8 4 1 4 2 4 4 4 2\n"
    "TYPE F F F U U I F F F I\nCOUNT 1 1 1 3 1 1 1 1 1 2\nWIDTH 2\nHEIGHT 1\n"
    "VIEWPOINT 1 2 3 0.5 0.5 0.5 0.5\nPOINTS 2\n";

struct Values {
  float x;
  double y;
  float z;
  uint32_t rgb;
  int16_t ring;
  float normal[3];
  int16_t hist[2];
};
constexpr Values kValues[2] = {{1.5f, -2.25, 3, 0x0A141E, -5, {0, 0, 1}, {7, -8}},
                               {4, 6861000.125, -6, 0xFF0001, 300, {0, 1, 0}, {9, 10}}};

template <class T>
void put(std::string& out, T value) {
  char raw[sizeof value];
  store<T>(raw, value);
  out.append(raw, sizeof raw);
}

// The values of point i, or with a member number only that member: for both layouts.
std::string record(const Values& v, int member = -1) {
  std::string parts[10];
  put(parts[0], v.x), put(parts[1], v.y), put(parts[2], v.z);
  parts[3] = "\1\2\3";
  put(parts[4], v.rgb), put(parts[5], v.ring);
  for (int k = 0; k < 3; ++k) put(parts[6 + k], v.normal[k]);
  put(parts[9], v.hist[0]), put(parts[9], v.hist[1]);
  if (member >= 0) return parts[member];
  std::string out;
  for (const std::string& part : parts) out += part;
  return out;
}

// As literals alone, at most 32 bytes each.
std::string packed(const std::string& bytes) {
  std::string out;
  for (size_t at = 0; at < bytes.size(); at += 32) {
    const std::string piece = bytes.substr(at, 32);
    out += static_cast<char>(piece.size() - 1) + piece;
  }
  return out;
}

std::string compressed_body() {
  std::string columns;
  for (int m = 0; m < 10; ++m) columns += record(kValues[0], m) + record(kValues[1], m);
  const std::string body = packed(columns);
  std::string out;
  put(out, static_cast<uint32_t>(body.size()));
  put(out, static_cast<uint32_t>(columns.size()));
  return out + body;
}

}  // namespace

TEST_CASE("pcd__three_encodings_of_one_cloud_are_one_cloud") {
  const std::string bodies[] = {
      "DATA ascii\n1.5 -2.25 3 1 2 3 660510 -5 0 0 1 7 -8\n"
      "4 6861000.125 -6 1 2 3 16711681 300 0 1 0 9 10\n",
      "DATA binary\n" + record(kValues[0]) + record(kValues[1]),
      "DATA binary_compressed\n" + compressed_body()};
  for (const std::string& body : bodies) {
    CAPTURE(body.substr(0, 22));
    const Cloud cloud = pcd_cloud(kMixed + body);
    REQUIRE(cloud.size() == 2);
    CHECK(cloud.point(0) == Vec3{1.5, -2.25, 3});
    CHECK(cloud.point(1) == Vec3{4, 6861000.125, -6});
    CHECK(cloud.fields.size() == 6);
    CHECK(cloud.fields.require("red").number(0) == 10);
    CHECK(cloud.fields.require("green").number(0) == 20);
    CHECK(cloud.fields.require("blue").number(0) == 30);
    CHECK(cloud.fields.require("red").number(1) == 255);
    CHECK(cloud.fields.require("ring").number(1) == 300);
    CHECK(cloud.fields.require("ring").info().type == ElementType::kInt16);
    CHECK(cloud.fields.require("normal").number(0, 2) == 1);
    CHECK(cloud.fields.require("normal").number(1, 1) == 1);
    CHECK(cloud.fields.require("hist").number(1, 1) == 10);
    REQUIRE(cloud.stations.size() == 1);
    CHECK(cloud.stations[0].count == 2);
    CHECK(cloud.stations[0].pose.translation() == Vec3{1, 2, 3});
    CHECK(norm(cloud.stations[0].pose.direction({1, 0, 0}) - Vec3{0, 1, 0}) < 1e-15);
  }
}

TEST_CASE("pcd__of_an_organised_cloud_the_empty_cells_go_and_the_grid_stays") {
  const std::string head =
      "VERSION .7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 3\nHEIGHT 2\n"
      "VIEWPOINT 0 0 0 1 0 0 0\nPOINTS 6\nDATA ascii\n";
  const Cloud cloud =
      pcd_cloud(head + "1 0 0\nnan nan nan\n2 0 0\nnan nan nan\nnan nan nan\n3 0 0\n");
  REQUIRE(cloud.size() == 3);
  CHECK(cloud.stations.empty());  // the origin stands for an unknown viewpoint
  CHECK(cloud.fields.require("row").number(2) == 1);
  CHECK(cloud.fields.require("column").number(1) == 2);
  CHECK(cloud.fields.require("column").number(2) == 2);
  const std::string row = "FIELDS x y z\nWIDTH 2\nPOINTS 2\nDATA ascii\n1 2 3\nnan nan nan\n";
  CHECK(has_text(refused_pcd(row), "point 1 has a coordinate that is not finite"));
  CHECK(pcd_cloud(row, true).size() == 1);
}

TEST_CASE("pcd__packed_colours_of_floats_are_their_bits") {
  const auto colour = std::bit_cast<float>(uint32_t{0x7F102030});
  std::string body;
  for (const float value : {1.0f, 2.0f, 3.0f, colour}) put(body, value);
  const Cloud cloud = pcd_cloud(
      "FIELDS x y z rgba\nSIZE 4 4 4 4\nTYPE F F F F\nCOUNT 1 1 1 1\nWIDTH 1\nHEIGHT 1\nPOINTS "
      "1\nDATA binary\n" +
      body);
  CHECK(cloud.fields.require("red").number(0) == 0x10);
  CHECK(cloud.fields.require("blue").number(0) == 0x30);
  CHECK(cloud.fields.require("alpha").number(0) == 0x7F);
}

TEST_CASE("pcd__what_is_wrong_is_named") {
  const std::string head = "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\n";
  CHECK(has_text(refused_pcd(head + "WIDTH 9\nDATA binary\n0123"),
                 "the header promises 9 points, the file has room for 0"));
  CHECK(has_text(refused_pcd(head + "WIDTH 2\nDATA ascii\n1 2 3\n\n\n\n\n\n\n"), "the file ends"));
  CHECK(has_text(refused_pcd(head + "WIDTH 1\nDATA ascii\n1 2\n   \n"), "fewer numbers"));
  CHECK(has_text(refused_pcd(head + "WIDTH 1\nDATA ascii\n1 2 3 4\n"), "more numbers"));
  CHECK(has_text(refused_pcd(head + "WIDTH 1\nDATA ascii\n1 2 3x\n"), "line 6: this is no number"));
  CHECK(has_text(refused_pcd(head + "WIDTH 2\nHEIGHT 2\nPOINTS 3\nDATA ascii\n"), "POINTS is not"));
  CHECK(has_text(refused_pcd(head + "WIDTH 0\n"), "no line DATA"));
  CHECK(has_text(refused_pcd("FIELDS x y z\nSIZE 4 4\nWIDTH 0\nDATA ascii\n"), "SIZE"));
  CHECK(has_text(refused_pcd("FIELDS x y z\nSIZE 4 4 3\nWIDTH 0\nDATA ascii\n"), "type"));
  CHECK(has_text(refused_pcd("FIELDS x y a\nWIDTH 0\nDATA ascii\n"), "needs one field z"));
  CHECK(has_text(refused_pcd("FIELDS x y z\nCOUNT 1 1 0\nWIDTH 0\nDATA ascii\n"), "COUNT"));
  CHECK(has_text(refused_pcd(head + "WIDTH 0\nVIEWPOINT 0 0 0 2 0 0 0\nDATA ascii\n"), "length 1"));
  CHECK(has_text(refused_pcd(head + "DATA ascii\n"), "neither WIDTH nor POINTS"));
  std::string cut = kMixed + "DATA binary_compressed\n" + compressed_body();
  CHECK(has_text(refused_pcd(cut.substr(0, cut.size() - 1)), "compressed bytes"));
  cut[cut.find("_compressed\n") + 20] = '\x7f';  // the first token looks back
  CHECK(has_text(refused_pcd(cut), "compressed bytes"));
}
