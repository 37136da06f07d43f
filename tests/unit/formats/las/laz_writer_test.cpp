// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// LAZ files of ours against the same cloud as LAS: every field in every bit, whatever the threads.
#include "formats/las/laz_writer.h"

#include <doctest/doctest.h>

#include <cstring>

#include "formats/codecs/codecs.h"
#include "formats/files/endian.h"
#include "formats/las/fields.h"
#include "formats/las/las.h"
#include "unit/formats/opened_file.h"

using namespace jalon;
using namespace jalon::test;

namespace {

bool skipped() {
  if (has_codecs()) return false;
  MESSAGE("skipped: built without JALON_WITH_RUST_FORMATS");
  return true;
}

/// Fields that make the plan choose a point format: bit 0 GPS time, 1 colours, 2 the new family, 3 NIR,
/// 4 wave packets.
Cloud cloud_of(unsigned wants, size_t n, uint64_t seed) {
  Cloud cloud = random_points(n, seed);
  RandomStream random(seed, 2);
  const auto add = [&](const char* name, ElementType type) {
    cloud.fields.set(random_column(name, type, 1, n, random));
  };
  add("intensity", ElementType::kUint16);
  add("user_data", ElementType::kUint8);
  add("own_f4", ElementType::kFloat32);
  cloud.fields.set(random_column("three", ElementType::kInt16, 3, n, random));
  if ((wants & 1) != 0) add("gps_time", ElementType::kFloat64);
  if ((wants & 2) != 0)
    for (const char* name : {"red", "green", "blue"}) add(name, ElementType::kUint16);
  if ((wants & 4) != 0) add("classification", ElementType::kUint8);
  if ((wants & 8) != 0) add("nir", ElementType::kUint16);
  if ((wants & 16) != 0)
    for (const las::Dimension& dimension : las::dimensions(4))
      for (const char* wave : las::kWaveNames)
        if (dimension.field.name == wave) add(wave, dimension.field.type);
  if ((wants & 20) == 20) {  // of several heads, which LAZ predicts each by its own
    std::vector<uint8_t> heads(n);
    for (uint8_t& head : heads) head = static_cast<uint8_t>(random.below(4));
    cloud.fields.set(make_column<uint8_t>({"scanner_channel"}, heads));
  }
  return cloud;
}

std::string bytes_of(const Cloud& cloud, const char* name, unsigned threads = 0) {
  const Folder folder;
  Task::Hooks hooks;
  hooks.threads = threads;
  Task task(hooks);
  write_cloud(cloud, folder.file(name), {}, task);
  return slurp(folder.file(name));
}

}  // namespace

TEST_CASE("laz_writer__holds_every_bit_of_the_las_file_in_every_point_format") {
  if (skipped()) return;
  constexpr size_t kPoints = 50001;  // a chunk and one point
  static constexpr struct {
    unsigned wants, format;
  } kCases[] = {{0, 0},  {1, 1},  {2, 2},  {3, 3},  {4, 6},  {6, 7},
                {14, 8}, {17, 4}, {19, 5}, {21, 9}, {31, 10}};
  for (const auto& [wants, expected] : kCases) {
    const unsigned format = expected;
    CAPTURE(format);
    const Cloud cloud = cloud_of(wants, kPoints, 40 + format);
    const std::string packed = bytes_of(cloud, "a.laz"), plain = bytes_of(cloud, "a.las");
    REQUIRE(static_cast<unsigned>(static_cast<uint8_t>(packed[104])) == (0x80u | format));
    CHECK(static_cast<unsigned>(plain[104]) == format);
    const OpenedFile a(packed, "a.laz"), b(plain, "b.las");
    const Cloud from_laz = read(a.path()), from_las = read(b.path());
    REQUIRE(from_laz.size() == kPoints);
    CHECK(std::memcmp(from_laz.xyz().data(), from_las.xyz().data(), from_las.xyz().size_bytes()) ==
          0);
    REQUIRE(from_laz.fields.size() == from_las.fields.size());
    for (const ColumnPtr& column : from_las.fields) {
      CAPTURE(column->info().name);
      const Column& other = from_laz.fields.require(column->info().name);
      CHECK(other.info().type == column->info().type);
      CHECK(std::memcmp(other.raw(), column->raw(), column->bytes()) == 0);
    }
  }
}

TEST_CASE("laz_writer__the_same_bytes_for_any_number_of_threads_and_fewer_than_las") {
  if (skipped()) return;
  const Cloud cloud = random_points(170000, 5);
  const std::string one = bytes_of(cloud, "a.laz", 1);
  CHECK(one == bytes_of(cloud, "a.laz", 2));
  CHECK(one == bytes_of(cloud, "a.laz", 3));
  CHECK(one.size() < bytes_of(cloud, "a.las").size());
}

TEST_CASE("laz_writer__empty_clouds_and_extended_records_are_written") {
  if (skipped()) return;
  CHECK(read(OpenedFile(bytes_of(Cloud{}, "a.laz"), "a.laz").path()).size() == 0);
  Cloud cloud = random_points(1000, 3);
  cloud.crs = "PROJCS[\"" + std::string(70000, 'x') + "\",UNIT[\"metre\",1]]";  // an EVLR
  const OpenedFile file(bytes_of(cloud, "a.laz"), "a.laz");
  const Cloud back = read(file.path());
  CHECK(back.size() == 1000);
  CHECK(std::string(back.crs) == std::string(cloud.crs));
}

TEST_CASE("laz_writer__stations_are_in_the_file_and_in_none_beside_it") {
  if (skipped()) return;
  Cloud cloud = random_points(100, 4);
  Station station;
  station.name = "west";
  station.count = cloud.size();
  cloud.stations = {station};
  const Folder folder;
  write(cloud, folder.file("a.laz"));
  CHECK(folder.entries() == 1);
  const Cloud back = read(folder.file("a.laz"));
  REQUIRE(back.stations.size() == 1);
  CHECK(std::string(back.stations[0].name) == "west");
}

TEST_CASE("laz_writer__without_the_component_the_line_says_what_to_install") {
  if (has_codecs()) return;
  const Folder folder;
  for (const char* name : {"a.laz", "a.e57"}) {
    const Failure failure = failure_of([&] { write(random_points(10, 1), folder.file(name)); });
    CHECK(failure.status == Status::kUnsupported);
    CHECK(has_text(failure.text, "cargo"));
  }
  CHECK(folder.entries() == 0);
}

// One place again and again: hundreds of points a byte, which no scanner's file has.
TEST_CASE("laz_writer__equal_points_come_back_and_no_more_than_there_are") {
  if (skipped()) return;
  constexpr size_t kPoints = 280000, kInChunk = 50000;
  Buffer<double> xyz(3 * kPoints);
  for (size_t i = 0; i < xyz.size(); ++i) xyz[i] = 1 + static_cast<double>(i % 3);
  const Cloud cloud = make_cloud(std::move(xyz));
  Task task;
  for (const char* name : {"a.laz", "a.copc.laz"}) {
    CAPTURE(name);
    const std::string bytes = bytes_of(cloud, name);
    REQUIRE(bytes.size() * 64 < kPoints);
    const OpenedFile file(bytes, name);
    const Cloud again = read_las(file, {}, task);
    REQUIRE(again.size() == kPoints);
    CHECK(again.point(kPoints - 1) == Vec3{1, 2, 3});
  }
  std::string lying = bytes_of(cloud, "a.laz");
  const uint64_t place = lying[25] == 4 ? 247 : 107;  // minor version; the number of points
  store<uint32_t>(lying.data() + place, 6 * kInChunk);
  const OpenedFile file(lying, "a.laz");
  const Failure failure = failure_of([&] { read_las(file, {}, task); });
  CHECK(failure.status == Status::kFormat);
  CHECK(has_text(failure.text, "chunk 6 of the compressed points"));
}
