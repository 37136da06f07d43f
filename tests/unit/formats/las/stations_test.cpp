// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/las/stations.h"

#include "formats/las/las.h"
#include "unit/formats/kept_log.h"
#include "unit/formats/stations_fixture.h"

using namespace jalon;
using namespace jalon::test;

namespace {

Cloud there_and_back(const Cloud& cloud, LasVersion version = LasVersion::kAuto) {
  const Folder folder;
  WriteSettings settings;
  settings.las_version = version;
  write(cloud, folder.file("a.las"), settings);
  CHECK(folder.entries() == 1);
  return read(folder.file("a.las"));
}

}  // namespace

TEST_CASE("las_stations__come_back_with_names_poses_points_and_no_field") {
  for (const LasVersion version : {LasVersion::k12, LasVersion::k14}) {
    const Cloud cloud = two_stations(true);
    const Cloud back = there_and_back(cloud, version);
    check_same_stations(back, cloud);
    CHECK(back.fields.find("station") == nullptr);
    check_same_stations(there_and_back(back, version), cloud);
  }
}

TEST_CASE("las_stations__leave_a_field_of_their_name_alone") {
  Cloud cloud = two_stations();
  cloud.fields.set(make_column<double>({"station"}, std::vector<double>(cloud.size(), 0.5)));
  const Cloud back = there_and_back(cloud);
  check_same_stations(back, cloud);
  CHECK(back.fields.require("station").values<double>()[3] == 0.5);
  CHECK(back.fields.find("station_2") == nullptr);
}

TEST_CASE("las_stations__come_back_without_any_field_wanted") {
  Cloud cloud = two_stations(true);
  cloud.fields.set(make_column<double>({"depth"}, std::vector<double>(cloud.size(), 0.5)));
  const Folder folder;
  write(cloud, folder.file("a.las"));
  ReadSettings settings;
  Task task;
  for (const char* fields : {"-", "depth", "colour?"}) {
    settings.fields = fields;
    const Cloud back = read_cloud(folder.file("a.las"), settings, task);
    check_same_stations(back, cloud);
    CHECK(back.fields.size() == (settings.fields == "depth" ? 1 : 0));
  }
}

TEST_CASE("las_stations__of_a_file_in_feet_come_back_in_metres") {
  Cloud cloud = two_stations();
  cloud.crs = "EPSG:2263";  // New York in US survey feet
  check_same_stations(there_and_back(cloud), cloud);
}

TEST_CASE("las_stations__survive_points_being_cut_out_of_the_file") {
  Task task;
  const Cloud cloud = two_stations();
  std::vector<uint64_t> some{1, 2, 11, 12, 13};
  const Cloud back = there_and_back(select(cloud, some, task));
  REQUIRE(back.stations.size() == 2);
  CHECK(back.stations[0].count == 2);
  CHECK(back.stations[1].first == 2);
}

TEST_CASE("las_stations__of_many_scanners_take_several_records") {
  Cloud cloud = random_points(1200, 1);
  for (uint64_t k = 0; k < 600; ++k) {
    Station s;
    s.name = "scanner " + std::to_string(k);
    s.has_pose = true;
    s.pose = rotation_by({0.01 * static_cast<double>(k), 0.3, 0.2});
    s.first = 2 * k;
    s.count = 2;
    cloud.stations.push_back(s);
  }
  CHECK(las::station_records(cloud, "station", {1, 1, 1}).size() > 1);
  check_same_stations(there_and_back(cloud, LasVersion::k12), cloud);
}

TEST_CASE("las_stations__of_a_broken_record_are_left_out_with_a_warning") {
  const Folder folder;
  write(two_stations(), folder.file("a.las"));
  std::string bytes = slurp(folder.file("a.las"));
  const size_t at = bytes.find("\"pose\":[");
  REQUIRE(at != std::string::npos);
  bytes[at + 8] = 'x';
  spill(folder.file("a.las"), bytes);
  KeptLog log;
  const Cloud cloud = read_cloud(folder.file("a.las"), {}, log.task());
  CHECK(cloud.stations.empty());
  CHECK(cloud.fields.find("station") != nullptr);
  CHECK(log.warnings().size() == 1);
}
