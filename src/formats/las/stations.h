// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "cloud/cloud.h"
#include "formats/las/layout.h"

// Stations in a LAS file, which knows none: an extra dimension with the number of each point's station, and records
// (user "Jalon", number 1) with their names and poses as JSON, in the unit of the file (include/jalon/io.h).
namespace jalon::las {

constexpr const char* kStationUser = "Jalon";
constexpr unsigned kStationRecord = 1;

bool is_station_record(const Record& record);
/// The dimension that numbers the points' stations; "" where none does.
std::string station_field(const std::vector<Record>& vlrs, const std::vector<Record>& evlrs);
/// What the records tell, lengths times these factors; the field that numbers them goes. Broken ones are a warning.
Cloud with_stations(Cloud cloud, const std::vector<Record>& vlrs, const std::vector<Record>& evlrs,
                    const Vec3& metres, const std::string& path, Task& task);
/// The dimension, with a name that no field has; null without stations.
ColumnPtr station_column(const Cloud& cloud, Task& task);
/// The records, for a dimension of this name and a unit of the file of so many metres.
std::vector<Record> station_records(const Cloud& cloud, const std::string& field,
                                    const Vec3& metres);

}  // namespace jalon::las
