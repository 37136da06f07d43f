// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/las/stations.h"

#include "base/error.h"
#include "formats/files/told_stations.h"

namespace jalon::las {

namespace {

constexpr const char* kFieldName = "station";
constexpr size_t kMostRecordBytes = 0xFFFF;  // of a VLR

ToldStations told_stations(const std::vector<Record>& vlrs, const std::vector<Record>& evlrs) {
  ToldStations told;
  for (const auto* list : {&vlrs, &evlrs})
    for (const Record& record : *list)
      if (is_station_record(record))
        read_stations({reinterpret_cast<const char*>(record.data()), record.size()}, told);
  return told;
}

}  // namespace

bool is_station_record(const Record& record) { return record.is(kStationUser, kStationRecord); }

std::string station_field(const std::vector<Record>& vlrs, const std::vector<Record>& evlrs) {
  try {
    return told_stations(vlrs, evlrs).field;
  } catch (const Error& error) {
    if (error.status() != Status::kFormat) throw;
    return {};  // with_stations tells why they are left out
  }
}

Cloud with_stations(Cloud cloud, const std::vector<Record>& vlrs, const std::vector<Record>& evlrs,
                    const Vec3& metres, const std::string& path, Task& task) {
  ToldStations told;
  try {
    told = told_stations(vlrs, evlrs);
  } catch (const Error& error) {
    if (error.status() != Status::kFormat) throw;
    task.log(Task::kWarning, "%s: the stations are left out: %s", path.c_str(), error.what());
    return cloud;
  }
  Cloud out = with_told_stations(std::move(cloud), told, metres, path, task);
  if (!out.stations.empty()) out.fields.remove(told.field);  // which the stations say now
  return out;
}

ColumnPtr station_column(const Cloud& cloud, Task& task) {
  if (cloud.stations.empty()) return nullptr;
  std::string name = kFieldName;
  for (int number = 2; cloud.fields.find(name) != nullptr; ++number)
    name = kFieldName + std::string("_") + std::to_string(number);
  ColumnPtr column = station_numbers(cloud, name);
  if (column == nullptr)
    task.log(Task::kWarning, "LAS numbers at most 65535 stations: they are left out");
  return column;
}

std::vector<Record> station_records(const Cloud& cloud, const std::string& field,
                                    const Vec3& metres) {
  std::vector<Record> out;
  for (const std::string& text : station_texts(cloud, field, metres, kMostRecordBytes))
    out.push_back(make_record(kStationUser, kStationRecord, "Stations", text.data(), text.size()));
  return out;
}

}  // namespace jalon::las
