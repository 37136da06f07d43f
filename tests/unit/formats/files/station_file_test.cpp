// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/files/station_file.h"

#include "unit/formats/kept_log.h"
#include "unit/formats/stations_fixture.h"

using namespace jalon;
using namespace jalon::test;

TEST_CASE("station_file__stands_beside_the_points_under_their_name") {
  CHECK(station_file_of("a/b.c/scan.xyz") == "a/b.c/scan.stations.json");
  CHECK(station_file_of("a/b.c/scan") == "a/b.c/scan.stations.json");
  CHECK(station_file_of("scan.city.csv") == "scan.city.stations.json");
}

TEST_CASE("station_file__brings_the_stations_of_formats_without_a_place_for_them") {
  const Folder folder;
  const Cloud cloud = two_stations(true);
  for (const char* name : {"a.xyz", "a.csv", "a.pcd"}) {
    write(cloud, folder.file(name));
    CHECK(folder.entries() == 2);
    check_same_stations(read(folder.file(name)), cloud);
    Cloud bare = cloud;
    bare.stations.clear();
    write(bare, folder.file(name));
    CHECK(folder.entries() == 1);
    CHECK(read(folder.file(name)).stations.empty());
    std::filesystem::remove(folder.file(name));
  }
}

TEST_CASE("station_file__of_another_cloud_is_left_alone") {
  const Folder folder;
  write(two_stations(), folder.file("a.xyz"));
  Cloud other = two_stations();
  other.stations.clear();
  write(other, folder.file("a.csv"));
  CHECK(read(folder.file("a.csv")).stations.empty());
  CHECK(read(folder.file("a.xyz")).stations.size() == 2);
}

TEST_CASE("station_file__by_hand_serves_every_format_by_a_field_or_a_position") {
  const Folder folder;
  spill(folder.file("a.stations.json"),
        R"({"jalon_stations": 1, "field": "scan", "stations": [
            {"name": "A", "value": 4, "position": [1, 2, 3]}, {"name": "B", "value": 2}]})");
  Cloud cloud = random_points(3, 1);
  cloud.fields.set(make_column<uint8_t>({"scan"}, std::vector<uint8_t>{2, 4, 4}));
  for (const char* name : {"a.las", "a.ply", "a.csv"}) {
    write(cloud, folder.file(name));
    const Cloud back = read(folder.file(name));
    REQUIRE(back.stations.size() == 2);
    CHECK(back.stations[1].pose.m[7] == 2);
    CHECK(back.fields.find("scan") != nullptr);
  }
}

TEST_CASE("station_file__that_is_broken_is_a_warning_and_stays") {
  const Folder folder;
  Cloud cloud = random_points(3, 1);
  for (const char* text :
       {"", "hello", "{\"jalon_stations\": 1, \"stations\": [{\"count\": 9}]}"}) {
    spill(folder.file("a.stations.json"), text);
    write(cloud, folder.file("a.xyz"));
    KeptLog log;
    CHECK(read_cloud(folder.file("a.xyz"), {}, log.task()).stations.empty());
    REQUIRE(log.warnings().size() == 1);
    CHECK(log.warnings()[0].find("a.stations.json: the stations are left out: ") !=
          std::string::npos);
    CHECK(slurp(folder.file("a.stations.json")) == text);
  }
  std::filesystem::remove(folder.file("a.stations.json"));
  std::filesystem::create_directory(folder.file("a.stations.json"));
  CHECK(read(folder.file("a.xyz")).size() == 3);
}
