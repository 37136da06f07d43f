// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// Points out of LAS records that were put together bit by bit after ASPRS LAS 1.4 R15.
#include <doctest/doctest.h>

#include <cmath>
#include <string>
#include <vector>

#include "formats/las/las.h"
#include "unit/formats/kept_log.h"
#include "unit/formats/las/las_bytes.h"
#include "unit/formats/opened_file.h"

using namespace jalon;
using namespace jalon::test;

namespace {

Cloud points_of(const LasBytes& made, const ReadSettings& settings = {}) {
  const OpenedFile file(made.bytes(), "a.las");
  Task task;
  return read_las(file, settings, task);
}

double value_of(const Cloud& cloud, const char* field, size_t i = 0, uint32_t component = 0) {
  return cloud.fields.require(field).number(i, component);
}

}  // namespace

TEST_CASE("las_reader__bit_fields_angles_and_colours_of_old_and_new_records_are_told_apart") {
  LasBytes old;
  old.format = 3;
  old.record_bytes = 34;
  size_t at = old.add_point(100, -200, 300);
  put_at(old.points, at + 12, uint16_t{65535});
  put_at(old.points, at + 14, uint8_t{0b10'101'011});  // edge, direction, returns, return
  put_at(old.points, at + 15, uint8_t{0b101'11111});   // withheld, key point, synthetic, class
  put_at(old.points, at + 16, int8_t{-90});
  put_at(old.points, at + 18, uint16_t{4321});
  put_at(old.points, at + 20, 123456.75);
  put_at(old.points, at + 32, uint16_t{999});  // blue
  const Cloud a = points_of(old);
  CHECK(norm(a.point(0) - Vec3{1, -2, 3}) <= 1e-15);
  CHECK(value_of(a, "intensity") == 65535);
  CHECK(value_of(a, "return_number") == 3);
  CHECK(value_of(a, "number_of_returns") == 5);
  CHECK(value_of(a, "scan_direction") == 0);
  CHECK(value_of(a, "edge_of_flight_line") == 1);
  CHECK(value_of(a, "classification") == 31);
  CHECK(value_of(a, "synthetic") == 1);
  CHECK(value_of(a, "key_point") == 0);
  CHECK(value_of(a, "withheld") == 1);
  CHECK(value_of(a, "scan_angle") == -90);
  CHECK(value_of(a, "point_source_id") == 4321);
  CHECK(value_of(a, "gps_time") == 123456.75);
  CHECK(value_of(a, "blue") == 999);
  CHECK(value_of(a, "red") == 0);

  LasBytes wide;
  wide.minor = 4;
  wide.format = 8;
  wide.record_bytes = 38;
  at = wide.add_point(0, 0, 0);
  put_at(wide.points, at + 14, uint8_t{0b1110'1101});    // returns, return
  put_at(wide.points, at + 15, uint8_t{0b0'1'10'1000});  // edge, direction, channel, flags
  put_at(wide.points, at + 16, uint8_t{200});
  put_at(wide.points, at + 18, int16_t{-30000});  // steps of 0.006 degrees
  put_at(wide.points, at + 36, uint16_t{77});
  const Cloud b = points_of(wide);
  CHECK(value_of(b, "return_number") == 13);
  CHECK(value_of(b, "number_of_returns") == 14);
  CHECK(value_of(b, "overlap") == 1);
  CHECK(value_of(b, "withheld") == 0);
  CHECK(value_of(b, "scanner_channel") == 2);
  CHECK(value_of(b, "scan_direction") == 1);
  CHECK(value_of(b, "edge_of_flight_line") == 0);
  CHECK(value_of(b, "classification") == 200);
  CHECK(value_of(b, "scan_angle") == -180);
  CHECK(value_of(b, "nir") == 77);
}

TEST_CASE("las_reader__every_point_of_many_blocks_stands_in_its_place_for_any_number_of_threads") {
  constexpr int32_t kPoints = 70000;  // more than a chunk of 65536, many blocks of 96 KiB
  LasBytes made;
  made.scale = 1;
  made.points.resize(size_t{kPoints} * made.record_bytes);
  for (int32_t i = 0; i < kPoints; ++i) {
    const size_t begin = static_cast<size_t>(i) * made.record_bytes;
    store<int32_t>(made.points.data() + begin, i);
    store<int32_t>(made.points.data() + begin + 8, -i);
    store<uint16_t>(made.points.data() + begin + 18, static_cast<uint16_t>(i % 65521));
  }
  const OpenedFile file(made.bytes());
  for (const unsigned threads : {1u, 3u}) {
    Task::Hooks hooks;
    hooks.threads = threads;
    Task task(hooks);
    const Cloud cloud = read_las(file, {}, task);
    REQUIRE(cloud.size() == size_t{kPoints});
    const auto ids = cloud.fields.require("point_source_id").values<uint16_t>();
    size_t wrong = 0;
    for (int32_t i = 0; i < kPoints; ++i) {
      const auto n = static_cast<size_t>(i);
      wrong += cloud.point(n) == Vec3{double(i), 0, -double(i)} && ids[n] == i % 65521 ? 0 : 1;
    }
    CHECK(wrong == 0);
  }
}

TEST_CASE("las_reader__the_unit_is_that_of_the_option_or_else_of_the_crs_and_degrees_are_told") {
  LasBytes made;
  made.scale = 1;
  made.add_point(1000, 2000, 3937);
  ReadSettings settings;
  settings.unit = FileUnit::kFeet;
  CHECK(points_of(made, settings).point(0).x == doctest::Approx(304.8).epsilon(1e-14));
  settings.unit = FileUnit::kUsSurveyFeet;
  CHECK(points_of(made, settings).point(0).z == doctest::Approx(1200).epsilon(1e-14));
  CHECK(points_of(made).point(0) == Vec3{1000, 2000, 3937});
  made.vlrs = las::crs_records(
      "COMPD_CS[\"c\",PROJCS[\"p\",UNIT[\"foot\",0.3048]],"
      "VERT_CS[\"v\",UNIT[\"metre\",1]]]");
  const Vec3 mixed = points_of(made).point(0);
  CHECK(mixed.y == doctest::Approx(609.6).epsilon(1e-14));
  CHECK(mixed.z == 3937);
  made.vlrs = las::crs_records("EPSG:4326");
  const OpenedFile file(made.bytes());
  KeptLog log;
  const Cloud degrees = read_las(file, {}, log.task());
  CHECK(degrees.point(0).x == 1000);
  CHECK(degrees.crs == "EPSG:4326");
  REQUIRE(log.warnings().size() == 1);
  CHECK(has_text(log.warnings()[0], "degrees"));
}

TEST_CASE(
    "las_reader__described_bytes_are_numbers_with_scale_and_shift_and_go_before_standard_ones") {
  std::vector<std::byte> height =
      las::descriptor_of({"", ElementType::kInt16, 2, "", ""}, "height");
  height[3] = std::byte{8 | 16};
  for (size_t c = 0; c < 2; ++c) {
    store<double>(height.data() + 112 + 8 * c, c == 0 ? 0.5 : -0.25);
    store<double>(height.data() + 136 + 8 * c, c == 0 ? 100.0 : 0.0);
  }
  LasBytes made;
  made.record_bytes = 20 + 4 + 4;
  made.vlrs = {extra_bytes_record(
      {height, las::descriptor_of({"", ElementType::kFloat32, 1, "", ""}, "intensity")})};
  const size_t at = made.add_point(0, 0, 0);
  put_at(made.points, at + 12, uint16_t{7});
  put_at(made.points, at + 20, int16_t{-3});
  put_at(made.points, at + 22, int16_t{8});
  put_at(made.points, at + 24, 0.125f);
  const Cloud cloud = points_of(made);
  CHECK(value_of(cloud, "height", 0, 0) == 98.5);
  CHECK(value_of(cloud, "height", 0, 1) == -2);
  CHECK(value_of(cloud, "intensity") == 0.125);
  const OpenedFile whole(made.bytes()), other("LASf" + made.bytes()), shorter("LAS");
  CHECK(is_las(whole));
  CHECK_FALSE(is_las(other));
  CHECK_FALSE(is_las(shorter));
}
