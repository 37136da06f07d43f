// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <iterator>

#include "base/error.h"
#include "base/json_cursor.h"
#include "base/json_writer.h"
#include "formats/files/told_stations.h"
#include "formats/files/utf8.h"

namespace jalon {

namespace {

constexpr int64_t kVersion = 1;
constexpr size_t kMostStations = 65535;  // what the field of a LAS file can number
constexpr size_t kMostNameBytes = 256;

class Refusal : public JsonListener {
 public:
  void refuse(uint64_t byte, const char* expected) const override {
    fail(Status::kFormat, "%s was expected at byte %llu", expected,
         static_cast<unsigned long long>(byte));
  }
};

uint64_t whole_number(JsonCursor& json) {
  const int64_t n = json.integer();
  if (n < 0) json.refuse("a number from 0 on");
  return static_cast<uint64_t>(n);
}

// The three first rows of a 4 x 4 matrix, row by row.
void read_pose(JsonCursor& json, Station& station) {
  if (json.kind() == JsonCursor::Kind::kNull) return json.null();
  json.begin_array();
  size_t n = 0;
  while (json.next_element()) {
    if (n == station.pose.m.size()) json.refuse("the end of the pose's 12 numbers");
    station.pose.m[n++] = json.number();
  }
  if (n != station.pose.m.size()) json.refuse("12 numbers of a pose");
  station.has_pose = true;
}

// Of an upright scanner whose turn nobody knows.
void read_position(JsonCursor& json, Station& station) {
  json.begin_array();
  size_t n = 0;
  while (json.next_element()) {
    if (n == 3) json.refuse("the end of the position's three numbers");
    station.pose.m[4 * n++ + 3] = json.number();
  }
  if (n != 3) json.refuse("three numbers of a position");
  station.has_pose = true;
}

ToldStations::One read_station(JsonCursor& json) {
  ToldStations::One out;
  json.begin_object();
  for (std::string name; json.next_member(name);) {
    if (name == "name") {
      const std::string text = valid_utf8(json.text());
      out.station.name = std::string(utf8_prefix(text, kMostNameBytes));
    } else if (name == "first") {
      out.station.first = whole_number(json);
    } else if (name == "count") {
      out.station.count = whole_number(json);
    } else if (name == "value") {
      out.value = json.number();
    } else if (name == "pose") {
      read_pose(json, out.station);
    } else if (name == "position") {
      read_position(json, out.station);
    } else {
      json.skip();
    }
  }
  return out;
}

void write_station(JsonWriter& json, const Station& station, uint64_t number, bool by_field,
                   const Vec3& metres) {
  json.begin_object().name("name").value(station.name.str());
  if (by_field) json.name("value").value(number);
  else json.name("first").value(station.first).name("count").value(station.count);
  if (station.has_pose) {
    json.name("pose").begin_array();
    for (size_t k = 0; k < station.pose.m.size(); ++k)
      json.value(k % 4 == 3 ? station.pose.m[k] / metres[static_cast<int>(k / 4)]
                            : station.pose.m[k]);
    json.end_array();
  }
  json.end_object();
}

std::string text_of_some(const Cloud& cloud, const std::string& field, const Vec3& metres,
                         int indent, const std::string& file, size_t begin, size_t end) {
  JsonWriter json(indent);
  json.begin_object().name("jalon_stations").value(kVersion);
  if (!file.empty()) json.name("file").value(file);
  if (!field.empty()) json.name("field").value(field);
  else json.name("points").value(cloud.size());
  json.name("stations").begin_array();
  for (size_t k = begin; k < end; ++k)
    write_station(json, cloud.stations[k], k + 1, !field.empty(), metres);
  json.end_array().end_object();
  return json.take();
}

}  // namespace

void read_stations(std::string_view text, ToldStations& told) {
  const Refusal refusal;
  JsonCursor json(text, refusal);
  json.begin_object();
  bool is_ours = false;
  for (std::string name; json.next_member(name);) {
    if (name == "jalon_stations") {
      is_ours = json.integer() == kVersion;
    } else if (name == "file") {
      told.file = valid_utf8(json.text());
    } else if (name == "field") {
      told.field = valid_utf8(json.text());
    } else if (name == "points") {
      told.points = whole_number(json);
    } else if (name == "stations") {
      json.begin_array();
      while (json.next_element()) {
        if (told.stations.size() == kMostStations) json.refuse("the end of 65535 stations");
        told.stations.push_back(read_station(json));
      }
    } else {
      json.skip();
    }
  }
  json.end();
  if (!is_ours) fail(Status::kFormat, "\"jalon_stations\": 1 is missing");
}

std::vector<std::string> station_texts(const Cloud& cloud, const std::string& field,
                                       const Vec3& metres, size_t most_bytes, int indent,
                                       const std::string& file) {
  std::vector<std::string> out;
  const size_t count = cloud.stations.size();
  for (size_t begin = 0; begin < count;) {
    size_t some = count - begin;
    std::string text = text_of_some(cloud, field, metres, indent, file, begin, begin + some);
    while (text.size() > most_bytes && some > 1) {
      some = (some + 1) / 2;
      text = text_of_some(cloud, field, metres, indent, file, begin, begin + some);
    }
    if (text.size() > most_bytes) fail(Status::kLimit, "the name of a station is too long");
    out.push_back(std::move(text));
    begin += some;
  }
  return out;
}

}  // namespace jalon
