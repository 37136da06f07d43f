// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
// COPC files of ours against the same cloud as LAS: whole, by box, by level.
#include "formats/las/copc_writer.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstring>

#include "cloud/operations.h"
#include "formats/units/epsg_wkt.h"
#include "formats/units/length_units.h"
#include "unit/formats/kept_log.h"
#include "unit/formats/las/copc_files.h"

using namespace jalon;
using namespace jalon::test;

namespace {

/// With fields that need point format 6, 7 or 8, and some that no format has.
Cloud cloud_of(unsigned format, size_t n, uint64_t seed) {
  Cloud cloud = wall_and_ground(n, seed);
  RandomStream random(seed, 2);
  const auto add = [&](const char* name, ElementType type, uint32_t components = 1) {
    cloud.fields.set(random_column(name, type, components, n, random));
  };
  for (const char* name : {"intensity", "point_source_id"}) add(name, ElementType::kUint16);
  for (const char* name : {"classification", "user_data"}) add(name, ElementType::kUint8);
  add("gps_time", ElementType::kFloat64);
  add("scan_angle", ElementType::kFloat32);
  add("three", ElementType::kInt16, 3);
  add("own_f4", ElementType::kFloat32);
  if (format >= 7)
    for (const char* name : {"red", "green", "blue"}) add(name, ElementType::kUint16);
  if (format == 8) add("nir", ElementType::kUint16);
  return cloud;
}

Cloud as_las(const Cloud& cloud) {
  const Folder folder;
  WriteSettings settings;
  settings.las_version = LasVersion::k14;
  write(cloud, folder.file("a.las"), settings);
  return read(folder.file("a.las"));
}

/// The points in the order of their ids.
Cloud by_id(const Cloud& cloud) {
  const std::vector<uint32_t> ids = ids_of(cloud);
  std::vector<uint64_t> order(ids.size());
  for (size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::ranges::sort(order, {}, [&](uint64_t i) { return ids[i]; });
  Task task;
  return select(cloud, order, task);
}

void check_same_bits(const Cloud& a, const Cloud& b) {
  REQUIRE(a.size() == b.size());
  REQUIRE(a.fields.size() == b.fields.size());
  if (b.size() == 0) return;
  CHECK(std::memcmp(a.xyz().data(), b.xyz().data(), b.xyz().size_bytes()) == 0);
  for (const ColumnPtr& column : b.fields) {
    CAPTURE(column->info().name);
    const Column& other = a.fields.require(column->info().name);
    CHECK(other.info().type == column->info().type);
    CHECK(std::memcmp(other.raw(), column->raw(), column->bytes()) == 0);
  }
}

}  // namespace

TEST_CASE("copc_writer__holds_every_bit_of_the_las_file_in_every_point_format") {
  if (lacks_codecs()) return;
  for (const unsigned format : {6u, 7u, 8u}) {
    CAPTURE(format);
    const Cloud cloud = cloud_of(format, 20000, format);
    const std::string bytes = copc_bytes(cloud);
    CHECK(static_cast<uint8_t>(bytes[104]) == (0x80u | format));
    const OpenedFile file(bytes, "a.copc.laz");
    CHECK(is_copc(file));
    const Cloud whole = read(file.path());
    check_same_bits(by_id(whole), as_las(cloud));
    // The whole and all of it found by the hierarchy are the same, in the same order.
    ReadSettings all;
    all.spacing_m = 1e-9;
    check_same_bits(read(file.path(), all), whole);
  }
}

TEST_CASE("copc_writer__the_same_bytes_for_any_number_of_threads") {
  if (lacks_codecs()) return;
  const Cloud cloud = cloud_of(7, 40000, 9);
  const std::string one = copc_bytes(cloud, 1);
  CHECK(one == copc_bytes(cloud, 2));
  CHECK(one == copc_bytes(cloud, 3));
}

TEST_CASE("copc_writer__a_code_of_epsg_becomes_wkt_or_one_line_that_says_why_not") {
  if (lacks_codecs()) return;
  static constexpr struct {
    const char* crs;
    bool is_known;
  } kCases[] = {
      {"EPSG:2154", true}, {"EPSG:32631", true}, {"EPSG:27700", false}, {"our grid", false}};
  for (const auto& row : kCases) {
    const char* crs = row.crs;
    const bool is_known = row.is_known;
    CAPTURE(crs);
    Cloud cloud = wall_and_ground(1000, 11);
    cloud.crs = crs;
    const Folder folder;
    KeptLog log;
    write_cloud(cloud, folder.file("a.copc.laz"), {}, log.task());
    CHECK(log.warnings().size() == (is_known ? 0 : 1));
    const Cloud back = read(folder.file("a.copc.laz"));
    CHECK(std::string(back.crs) == crs);
    const std::string wkt = wkt_of_epsg(epsg_code(crs));
    CHECK(wkt.empty() == !is_known);
    if (is_known) CHECK(slurp(folder.file("a.copc.laz")).find(wkt) != std::string::npos);
    write(back, folder.file("b.copc.laz"));  // the records stay as they are
    CHECK(std::string(read(folder.file("b.copc.laz")).crs) == std::string(back.crs));
    // Of a LAS file, whose keys stay beside the text.
    write(cloud, folder.file("a.las"));
    const Cloud old = read(folder.file("a.las"));
    CHECK(std::string(old.crs) == crs);
    write(old, folder.file("c.copc.laz"));
    CHECK(std::string(read(folder.file("c.copc.laz")).crs) == std::string(back.crs));
  }
}

TEST_CASE("copc_writer__a_box_read_is_the_whole_cropped") {
  if (lacks_codecs()) return;
  Cloud cloud = wall_and_ground(30000, 11);
  for (const char* crs : {"", "PROJCS[\"p\",UNIT[\"US survey foot\",0.304800609601219]]"}) {
    cloud.crs = crs;
    const OpenedFile file(copc_bytes(cloud), "a.copc.laz");
    const Cloud whole = read(file.path());
    RandomStream random(12, 1);
    size_t found = 0;
    for (int round = 0; round < 20; ++round) {
      Box3 box;
      const Vec3 low{652000, 6860999, 99}, size{30, 21, 13};
      for (int corner = 0; corner < 2; ++corner)
        box.add(low + Vec3{size.x * random.uniform(), size.y * random.uniform(),
                           size.z * random.uniform()});
      // Faces that go through points belong to the box.
      if (round % 4 == 0) box.max.x = whole.point(random.below(whole.size())).x;
      if (box.empty()) continue;
      Task task;
      const Cloud cropped = select_mask(whole, inside_box(whole, box, Transform{}, task), 1, task);
      check_same_bits(read(file.path(), in_box(box)), cropped);
      found += cropped.size();
    }
    CHECK(found > 300);
    CHECK(read(file.path(), in_box({{0, 0, 0}, {1, 1, 1}})).size() == 0);
  }
}

TEST_CASE("copc_writer__levels_share_out_the_points_and_each_adds_to_the_ones_above") {
  if (lacks_codecs()) return;
  const OpenedFile file(copc_bytes(wall_and_ground(60000, 13)), "a.copc.laz");
  const std::string bytes = slurp(file.path());
  const double spacing = get_at<double>(bytes, kCopcInfoAt + 32);
  const std::vector<NodeInFile> nodes = nodes_in(bytes);
  std::vector<uint32_t> above;
  for (int level = 0; level <= nodes.back().entry.key.level; ++level) {
    size_t expected = 0;
    for (const NodeInFile& node : nodes)
      if (node.entry.key.level <= level) expected += static_cast<size_t>(node.entry.points);
    ReadSettings settings;
    settings.spacing_m = std::ldexp(spacing, -level);
    std::vector<uint32_t> ids = ids_of(read(file.path(), settings));
    CHECK(ids.size() == expected);
    CHECK(ids.size() > above.size());
    settings.spacing_m *= 1.9;  // still too coarse one level up
    CHECK(ids_of(read(file.path(), settings)) == ids);
    std::ranges::sort(ids);
    CHECK(std::ranges::includes(ids, above));
    above = ids;
  }
  CHECK(above.size() == 60000);
  ReadSettings coarsest;
  coarsest.spacing_m = 1e6;
  CHECK(read(file.path(), coarsest).size() == static_cast<size_t>(nodes[0].entry.points));
}

TEST_CASE("copc_writer__records_and_stations_come_back_and_go_into_no_other_file") {
  if (lacks_codecs()) return;
  Cloud cloud = wall_and_ground(30000, 15);
  cloud.crs = "PROJCS[\"" + std::string(70000, 'x') + "\",UNIT[\"metre\",1]]";  // an EVLR
  Station west, east;
  west.name = "west";
  west.count = 10000;
  east.name = "east";
  east.first = 10000;
  east.count = 20000;
  cloud.stations = {west, east};
  const Folder folder;
  write(cloud, folder.file("a.copc.laz"));
  CHECK(folder.entries() == 1);
  const Cloud back = read(folder.file("a.copc.laz"));
  CHECK(std::string(back.crs) == std::string(cloud.crs));
  REQUIRE(back.stations.size() == 2);
  CHECK(std::string(back.stations[1].name) == "east");
  CHECK(back.stations[1].count == 20000);
  const Cloud part =
      read(folder.file("a.copc.laz"), in_box({{652000, 6e6, 0}, {652015, 7e6, 999}}));
  REQUIRE(part.stations.size() == 2);
  for (const auto& [station, least, end] :
       {std::tuple{0, 0u, 10000u}, std::tuple{1, 10000u, 30000u}}) {
    const Station& of = part.stations[static_cast<size_t>(station)];
    CHECK(of.count > 0);
    const std::vector<uint32_t> ids = ids_of(part);
    for (size_t i = of.first; i < of.first + of.count; ++i)
      CHECK((ids[i] >= least && ids[i] < end));
  }
  write(back, folder.file("b.las"));
  CHECK(slurp(folder.file("b.las")).find("copc") == std::string::npos);
  // As COPC again it has one record of each.
  write(back, folder.file("c.copc.laz"));
  CHECK(read(folder.file("c.copc.laz")).size() == 30000);
  CHECK(get_at<uint32_t>(slurp(folder.file("c.copc.laz")), 243) == 2);
}

TEST_CASE("copc_writer__stations_by_ranges_of_all_points_are_of_no_part") {
  if (lacks_codecs()) return;
  const Folder folder;
  write(wall_and_ground(500, 16), folder.file("a.copc.laz"));
  spill(folder.file("a.copc.stations.json"),
        R"({"jalon_stations": 1, "stations": [{"name": "west", "first": 0, "count": 100}]})");
  CHECK(read(folder.file("a.copc.laz")).stations.size() == 1);
  KeptLog log;
  const ReadSettings settings = in_box({{0, 0, 0}, {1e9, 1e9, 1e9}});
  CHECK(read_cloud(folder.file("a.copc.laz"), settings, log.task()).stations.empty());
  REQUIRE(log.warnings().size() == 1);
  CHECK(has_text(log.warnings()[0], "ranges of all points"));
}

TEST_CASE("copc_writer__times_empty_clouds_and_versions_that_cannot_be") {
  if (lacks_codecs()) return;
  Cloud cloud = wall_and_ground(3, 1);
  const double times[] = {5.5, -2, 7};
  cloud.fields.set(make_column<double>({"gps_time"}, times));
  const std::string bytes = copc_bytes(cloud);
  CHECK(get_at<double>(bytes, kCopcInfoAt + 56) == -2);
  CHECK(get_at<double>(bytes, kCopcInfoAt + 64) == 7);
  const OpenedFile empty(copc_bytes(Cloud{}), "a.copc.laz");
  CHECK(read(empty.path()).size() == 0);
  CHECK(read(empty.path(), in_box({{0, 0, 0}, {1, 1, 1}})).size() == 0);
  const Folder folder;
  WriteSettings old;
  old.las_version = LasVersion::k12;
  const Failure failure = failure_of([&] { write(cloud, folder.file("a.copc.laz"), old); });
  CHECK(failure.status == Status::kInvalidArgument);
  CHECK(has_text(failure.text, "LAS 1.4"));
  CHECK(folder.entries() == 0);
}
