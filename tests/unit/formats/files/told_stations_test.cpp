// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/files/told_stations.h"

#include "unit/formats/kept_log.h"
#include "unit/formats/stations_fixture.h"

using namespace jalon;
using namespace jalon::test;

namespace {

Cloud with(const std::string& text, Cloud cloud, KeptLog& log, const Vec3& metres = {1, 1, 1}) {
  ToldStations told;
  read_stations(text, told);
  return with_told_stations(std::move(cloud), told, metres, "a.xyz", log.task());
}

std::string one_station(const std::string& members) {
  return R"({"jalon_stations": 1, "points": 10, "stations": [{)" + members + "}]}";
}

}  // namespace

TEST_CASE("told_stations__by_ranges_have_names_poses_and_points") {
  KeptLog log;
  const Cloud cloud =
      with(one_station(R"("name": "A", "first": 2, "count": 5, "position": [1, 2, 3])"),
           random_points(10, 1), log, {0.5, 0.5, 2});
  REQUIRE(cloud.stations.size() == 1);
  CHECK(cloud.stations[0].name == "A");
  CHECK(cloud.stations[0].first == 2);
  CHECK(cloud.stations[0].count == 5);
  CHECK(cloud.stations[0].pose.m[3] == 0.5);
  CHECK(cloud.stations[0].pose.m[7] == 1);
  CHECK(cloud.stations[0].pose.m[11] == 6);
  CHECK(log.warnings().empty());
}

TEST_CASE("told_stations__that_do_not_fit_the_points_are_left_out_with_a_warning") {
  for (const char* members :
       {R"("first": 0, "count": 11)", R"("first": 11, "count": 0)",
        R"("first": 5, "count": 18446744073709)", R"("count": 1}, {"first": 0, "count": 1)",
        R"("count": 10, "pose": [2, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0])",
        R"("count": 10, "pose": [1e300, 0, 0, 0, 0, 1e300, 0, 0, 0, 0, 1, 0])"}) {
    KeptLog log;
    CHECK(with(one_station(members), random_points(10, 1), log).stations.empty());
    REQUIRE(log.warnings().size() == 1);
    CHECK(log.warnings()[0].find("a.xyz: the stations are left out: ") == 0);
  }
  KeptLog log;
  CHECK(with(one_station(R"("count": 3)"), random_points(9, 1), log).stations.empty());
  CHECK(log.warnings().size() == 1);
}

TEST_CASE("told_stations__by_a_field_put_points_in_their_order_where_they_are_not") {
  const std::string text = R"({"jalon_stations": 1, "field": "scan", "stations": [
      {"name": "A", "value": 7, "position": [0, 0, 1]}, {"name": "B", "value": 3}]})";
  KeptLog log;
  Cloud cloud = random_points(6, 1);
  cloud.fields.set(make_column<int32_t>({"scan"}, std::vector<int32_t>{3, 3, 7, 7, 9, 9}));
  const Cloud kept = with(text, cloud, log);
  REQUIRE(kept.stations.size() == 2);
  CHECK(kept.stations[0].name == "B");
  CHECK(kept.stations[1].first == 2);
  CHECK(kept.stations[1].count == 2);
  CHECK(kept.xyz_buffer == cloud.xyz_buffer);
  CHECK(log.warnings().empty());
  cloud.fields.set(make_column<int32_t>({"scan"}, std::vector<int32_t>{3, 7, 3, 7, 9, 3}));
  const Cloud sorted = with(text, cloud, log);
  REQUIRE(sorted.stations.size() == 2);
  CHECK(sorted.stations[0].name == "A");
  CHECK(sorted.stations[0].count == 2);
  CHECK(sorted.stations[1].count == 3);
  CHECK(norm(sorted.point(1) - cloud.point(3)) == 0);
  CHECK(norm(sorted.point(5) - cloud.point(4)) == 0);
  CHECK(log.warnings().size() == 1);
  cloud.fields.remove("scan");
  CHECK(with(text, cloud, log).stations.empty());
}

TEST_CASE("station_numbers__count_from_one_and_grow_with_the_stations") {
  const Cloud cloud = two_stations();
  const auto few = station_numbers(cloud, "station");
  CHECK(few->values<uint8_t>()[0] == 1);
  CHECK(few->values<uint8_t>()[cloud.size() - 1] == 2);
  Cloud many = random_points(300, 1);
  for (uint64_t k = 0; k < 300; ++k) {
    many.stations.emplace_back().first = k;
    many.stations.back().count = 1;
  }
  CHECK(station_numbers(many, "station")->values<uint16_t>()[299] == 300);
  many.stations.resize(70000);
  CHECK(station_numbers(many, "station") == nullptr);
}
