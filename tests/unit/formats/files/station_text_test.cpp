// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/files/told_stations.h"
#include "unit/formats/stations_fixture.h"

using namespace jalon;
using namespace jalon::test;

TEST_CASE("station_text__comes_back_with_all_digits_in_one_text_or_several") {
  const Cloud cloud = two_stations(true);
  const size_t whole = station_texts(cloud, "", {1, 1, 1}, 100000)[0].size();
  for (const size_t most : {whole, whole - 1}) {
    ToldStations told;
    const auto texts = station_texts(cloud, "", {1, 1, 1}, most);
    CHECK(texts.size() == (most < whole ? 2 : 1));
    for (const std::string& text : texts) read_stations(text, told);
    Cloud back = cloud;
    back.stations.clear();
    Task task;
    check_same_stations(with_told_stations(std::move(back), told, {1, 1, 1}, "a", task), cloud);
  }
}

TEST_CASE("station_text__in_another_unit_of_length_comes_back_in_metres") {
  const Cloud cloud = two_stations();
  ToldStations told;
  read_stations(station_texts(cloud, "scan", {0.3048, 0.3048, 0.5}, 100000)[0], told);
  CHECK(told.field == "scan");
  CHECK(told.stations[0].station.pose.m[3] == doctest::Approx(1000.25 / 0.3048));
  CHECK(told.stations[1].value == 2);
  CHECK_FALSE(told.stations[1].station.has_pose);
}

TEST_CASE("station_text__that_is_none_is_refused") {
  const auto refused = [](const std::string& text) {
    return failure_of([&] {
             ToldStations told;
             read_stations(text, told);
           }).status == Status::kFormat;
  };
  for (const char* text :
       {"", "{}", "[]", "null", R"({"jalon_stations": 2})", R"({"jalon_stations": 1} x)",
        R"({"jalon_stations": 1, "points": -1})", R"({"jalon_stations": 1, "stations": 3})",
        R"({"jalon_stations": 1, "stations": [3]})",
        R"({"jalon_stations": 1, "stations": [{"first": 0.5}]})",
        R"({"jalon_stations": 1, "stations": [{"pose": [1, 2, 3]}]})",
        R"({"jalon_stations": 1, "stations": [{"pose": [1,2,3,4,5,6,7,8,9,10,11,12,13]}]})",
        R"({"jalon_stations": 1, "stations": [{"position": [1, 2]}]})",
        R"({"jalon_stations": 1, "stations": [{"position": [1e999, 2, 3]}]})"})
    CHECK_MESSAGE(refused(text), text);
  std::string many = R"({"jalon_stations": 1, "stations": [{})";
  for (int k = 0; k < 65535; ++k) many += ",{}";
  CHECK(refused(many + "]}"));
  CHECK_FALSE(refused(R"({"jalon_stations": 1, "more": [1, {"a": 2}], "stations": []})"));
}
