// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// Written LAS files byte by byte against the tables of ASPRS LAS 1.4 R15, without the reader.
#include <doctest/doctest.h>

#include <cmath>
#include <string>
#include <vector>

#include "formats/las/las.h"
#include "unit/formats/las/las_bytes.h"
#include "unit/formats/opened_file.h"

using namespace jalon;
using namespace jalon::test;

namespace {

std::string file_of(const Cloud& cloud, LasVersion version = LasVersion::kAuto) {
  const Folder folder;
  WriteSettings settings;
  settings.las_version = version;
  Task task;
  write_las(cloud, folder.file("a.las"), settings, task);
  return slurp(folder.file("a.las"));
}

template <class T>
void set_field(Cloud& cloud, const char* name, const std::vector<T>& values) {
  cloud.fields.set(make_column<T>({name}, values));
}

Cloud line_of_points(size_t n) {
  Buffer<double> xyz(3 * n);
  for (size_t i = 0; i < 3 * n; ++i) xyz[i] = i % 3 == 0 ? static_cast<double>(i / 3) * 0.5 : 0;
  return make_cloud(std::move(xyz));
}

}  // namespace

TEST_CASE("las_writer__bits_of_the_record_are_those_of_the_table_in_both_families") {
  Cloud cloud = line_of_points(1);
  set_field<uint16_t>(cloud, "intensity", {0xABCD});
  set_field<uint8_t>(cloud, "return_number", {5});
  set_field<uint8_t>(cloud, "number_of_returns", {6});
  set_field<uint8_t>(cloud, "edge_of_flight_line", {1});
  set_field<uint8_t>(cloud, "classification", {9});
  set_field<uint8_t>(cloud, "key_point", {1});
  set_field<float>(cloud, "scan_angle", {-12});
  set_field<uint16_t>(cloud, "point_source_id", {777});
  set_field<double>(cloud, "gps_time", {-1.5});
  set_field<uint16_t>(cloud, "green", {0x0102});
  std::string bytes = file_of(cloud);
  CHECK(bytes[25] == 2);
  CHECK(bytes[104] == 3);
  CHECK(get_at<uint16_t>(bytes, 105) == 34);
  size_t at = get_at<uint32_t>(bytes, 96);
  CHECK(get_at<uint16_t>(bytes, at + 12) == 0xABCD);
  CHECK(get_at<uint8_t>(bytes, at + 14) == (1 << 7 | 6 << 3 | 5));
  CHECK(get_at<uint8_t>(bytes, at + 15) == (1 << 6 | 9));
  CHECK(get_at<int8_t>(bytes, at + 16) == -12);
  CHECK(get_at<uint16_t>(bytes, at + 18) == 777);
  CHECK(get_at<double>(bytes, at + 20) == -1.5);
  CHECK(get_at<uint16_t>(bytes, at + 28) == 0);
  CHECK(get_at<uint16_t>(bytes, at + 30) == 0x0102);
  CHECK(bytes.size() == at + 34);

  bytes = file_of(cloud, LasVersion::k14);
  CHECK(bytes[25] == 4);
  CHECK(bytes[104] == 7);
  at = get_at<uint32_t>(bytes, 96);
  CHECK(get_at<uint8_t>(bytes, at + 14) == (6 << 4 | 5));
  CHECK(get_at<uint8_t>(bytes, at + 15) == (1 << 7 | 1 << 1));
  CHECK(get_at<uint8_t>(bytes, at + 16) == 9);
  CHECK(get_at<int16_t>(bytes, at + 18) == -2000);  // -12 degrees in steps of 0.006
  CHECK(get_at<double>(bytes, at + 22) == -1.5);
  CHECK(get_at<uint16_t>(bytes, at + 32) == 0x0102);
}

TEST_CASE("las_writer__counts_by_return_stand_where_the_version_has_them") {
  Cloud cloud = line_of_points(120);
  std::vector<uint8_t> returns(120);  // number r stands r times from 1 to 15
  for (size_t r = 1, i = 0; r <= 15; ++r)
    for (size_t k = 0; k < r; ++k) returns[i++] = static_cast<uint8_t>(r);
  set_field(cloud, "return_number", returns);
  const std::string wide = file_of(cloud, LasVersion::k14);
  CHECK(get_at<uint64_t>(wide, 247) == 120);
  CHECK(get_at<uint32_t>(wide, 107) == 0);  // formats 6-10 leave the old count empty
  for (size_t r = 1; r <= 15; ++r) CHECK(get_at<uint64_t>(wide, 255 + 8 * (r - 1)) == r);

  for (uint8_t& number : returns) number = number > 7 ? 1 : number;
  set_field(cloud, "return_number", returns);
  const std::string old = file_of(cloud);
  REQUIRE(old[25] == 2);
  CHECK(get_at<uint32_t>(old, 107) == 120);
  const uint32_t eight_and_more = 8 + 9 + 10 + 11 + 12 + 13 + 14 + 15;
  CHECK(get_at<uint32_t>(old, 111) == 1 + eight_and_more);
  for (uint32_t r = 2; r <= 5; ++r) CHECK(get_at<uint32_t>(old, 111 + 4 * (r - 1)) == r);
}

TEST_CASE("las_writer__what_identifies_the_old_file_stays_and_records_lie_where_the_header_says") {
  LasBytes made;
  made.minor = 4;
  made.format = 6;
  made.record_bytes = 30;
  made.vlrs = {las::make_record("maker", 5, "what it is", "abc", 3)};
  made.evlrs = {extended_record("maker", 6, "behind the points")};
  made.add_point(1, 2, 3);
  std::string before = made.bytes();
  put_at(before, 4, uint16_t{4242});   // file source
  put_at(before, 6, uint16_t{1 | 2});  // GPS time type; waveforms inside, which are not written
  before.replace(8, 16, "0123456789abcdef");
  before.replace(26, 12, "MOBILE-THING");
  put_at(before, 90, uint16_t{200});
  put_at(before, 92, uint16_t{2019});
  const Folder folder;
  spill(folder.file("old.las"), before);
  Cloud cloud = read(folder.file("old.las"));
  const std::string after = file_of(cloud);
  CHECK(after.substr(8, 50) == before.substr(8, 50));
  CHECK(after.substr(90, 4) == before.substr(90, 4));
  CHECK(get_at<uint16_t>(after, 4) == 4242);
  CHECK(get_at<uint16_t>(after, 6) == 1);
  CHECK(after.substr(375, 57) == before.substr(375, 57));
  const uint64_t behind = get_at<uint64_t>(after, 235);
  CHECK(behind == get_at<uint32_t>(after, 96) + 30);
  CHECK(after.substr(behind) == before.substr(get_at<uint64_t>(before, 235)));
  CHECK(get_at<uint32_t>(after, 243) == 1);
  cloud.crs = "PROJCS[\"p\",UNIT[\"metre\",1]]";
  CHECK(get_at<uint16_t>(file_of(cloud), 6) == (1 | 16));  // the CRS is WKT
}

namespace {

void add_wave_packets(Cloud& cloud) {
  set_field<uint8_t>(cloud, "wavepacket_index", {7});
  set_field<uint64_t>(cloud, "wavepacket_offset", {60});
  set_field<uint32_t>(cloud, "wavepacket_size", {256});
  for (const char* name : {"return_point_wave_location", "x_t", "y_t", "z_t"})
    set_field<float>(cloud, name, {-0.25F});
}

}  // namespace

TEST_CASE("las_writer__wave_packets_make_the_point_formats_that_hold_them") {
  static constexpr struct {
    LasVersion version;
    bool green;
    int minor, format, wave;
  } kCases[] = {{LasVersion::kAuto, false, 3, 4, 28},
                {LasVersion::kAuto, true, 3, 5, 34},
                {LasVersion::k14, false, 4, 9, 30},
                {LasVersion::k14, true, 4, 10, 38}};
  for (const auto& [version, green, minor, format, wave] : kCases) {
    Cloud cloud = line_of_points(1);
    add_wave_packets(cloud);
    if (green) set_field<uint16_t>(cloud, "green", {5});
    const std::string bytes = file_of(cloud, version);
    const size_t at = get_at<uint32_t>(bytes, 96) + static_cast<size_t>(wave);
    CHECK(bytes[25] == minor);
    CHECK(bytes[104] == format);
    CHECK(get_at<uint16_t>(bytes, 94) == (minor == 3 ? 235 : 375));
    CHECK(get_at<uint16_t>(bytes, 105) == wave + 29);
    CHECK(get_at<uint8_t>(bytes, at) == 7);
    CHECK(get_at<uint64_t>(bytes, at + 1) == 60);
    CHECK(get_at<uint32_t>(bytes, at + 9) == 256);
    CHECK(get_at<float>(bytes, at + 25) == -0.25F);
  }
  Cloud cloud = line_of_points(1);
  add_wave_packets(cloud);
  CHECK(file_of(cloud, LasVersion::k12)[104] == 0);  // extra bytes
  cloud = line_of_points(1);
  set_field<uint8_t>(cloud, "wavepacket_index", {7});
  CHECK(file_of(cloud)[104] == 0);  // a field of that name alone is no wave packet
}

TEST_CASE("las_writer__samples_of_waves_stay_where_the_header_says") {
  LasBytes made;
  made.minor = 4;
  made.format = 9;
  made.record_bytes = 59;
  made.evlrs = {extended_record("maker", 6, "before them"),
                extended_record("LASF_Spec", 65535, "the samples")};
  made.add_point(1, 2, 3);
  std::string before = made.bytes();
  const Folder folder;
  put_at(before, 6, uint16_t{2});
  spill(folder.file("inside.las"), before);
  const std::string inside = file_of(read(folder.file("inside.las")));
  CHECK(inside[104] == 9);
  CHECK(get_at<uint16_t>(inside, 6) == 2);
  CHECK(get_at<uint64_t>(inside, 227) == get_at<uint64_t>(inside, 235) + 60 + 11);
  CHECK(inside.substr(get_at<uint64_t>(inside, 227) + 60) == "the samples");

  made.evlrs.clear();
  before = made.bytes();
  put_at(before, 6, uint16_t{4});
  spill(folder.file("beside.las"), before);
  const std::string beside = file_of(read(folder.file("beside.las")));
  CHECK(get_at<uint16_t>(beside, 6) == 4);
  CHECK(get_at<uint64_t>(beside, 227) == 0);
}

TEST_CASE("las_writer__batches_join_without_a_seam_and_a_file_without_points_is_whole") {
  constexpr size_t kPoints = 16500, kWide = 250;  // records above 512 bytes: 16384 a batch of 8 MiB
  Cloud cloud = line_of_points(kPoints);
  for (const char* name : {"a", "b"}) {
    auto column =
        std::make_shared<Column>(FieldInfo{name, ElementType::kUint8, kWide, "", ""}, kPoints);
    const auto values = column->values<uint8_t>();
    for (size_t i = 0; i < values.size(); ++i) values[i] = static_cast<uint8_t>(i / kWide % 251);
    cloud.fields.set(std::move(column));
  }
  const std::string bytes = file_of(cloud);
  const size_t stride = get_at<uint16_t>(bytes, 105), start = get_at<uint32_t>(bytes, 96);
  REQUIRE(stride == 20 + 2 * kWide);
  REQUIRE(bytes.size() == start + kPoints * stride);
  const double scale = get_at<double>(bytes, 131), offset = get_at<double>(bytes, 155);
  size_t wrong = 0;
  for (size_t i = 0; i < kPoints; ++i) {
    const size_t at = start + i * stride;
    const double x = get_at<int32_t>(bytes, at) * scale + offset;
    wrong += std::fabs(x - static_cast<double>(i) * 0.5) <= 0.5 * scale ? 0 : 1;
    for (const size_t k : {size_t{20}, stride / 2, stride - 1})
      wrong += get_at<uint8_t>(bytes, at + k) == i % 251 ? 0 : 1;
  }
  CHECK(wrong == 0);
  CHECK(get_at<double>(bytes, 179) == doctest::Approx((kPoints - 1) * 0.5).epsilon(1e-12));

  const std::string none = file_of(line_of_points(0));
  CHECK(none.size() == 227);
  for (size_t k = 0; k < 6; ++k) CHECK(get_at<double>(none, 179 + 8 * k) == 0);
}
