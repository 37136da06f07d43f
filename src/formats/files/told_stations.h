// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cloud/cloud.h"

namespace jalon {

/// The stations that a text beside the points tells of: comments of a PLY file, records of a LAS file, a file of its
/// own. JSON, the same everywhere (include/jalon/io.h describes it):
///
///   {"jalon_stations": 1, "points": 5000, "stations": [
///     {"name": "west", "first": 0, "count": 3000, "pose": [1, 0, 0, 12.5, 0, 1, 0, -3, 0, 0, 1, 1.7]}, ...]}
///
/// or with "field": "station" and a "value" of that field for each in the place of first and count.
struct ToldStations {
  struct One {
    Station station;
    double value = 0;  ///< of the field
  };
  std::string file;                ///< whose stations they are; "" = not said
  std::string field;               ///< "" = by ranges
  std::optional<uint64_t> points;  ///< of the cloud they are of
  std::vector<One> stations;
};

/// Adds what the text says; Error(kFormat) with the byte where it is not as described. Takes memory for what it keeps
/// only.
void read_stations(std::string_view text, ToldStations& told);
/// Gives the stations to the cloud, which has none: lengths times these factors. Points that the field tells not one
/// station after another are put in that order. Says in the log why told stations are left out; the points stand for
/// themselves.
Cloud with_told_stations(Cloud cloud, const ToldStations& told, const Vec3& metres,
                         const std::string& path, Task& task);

/// What is to be written of a cloud's stations, as texts of at most so many bytes each: what one record or comment
/// holds. field: the values of station k are k + 1; "": by ranges. metres: of the file's unit of length.
std::vector<std::string> station_texts(const Cloud& cloud, const std::string& field,
                                       const Vec3& metres, size_t most_bytes, int indent = -1,
                                       const std::string& file = "");
/// The number of each point's station from 1 on, 0 without: uint8, or uint16 where there are more than 255. Null where
/// there are more than 65535.
std::shared_ptr<Column> station_numbers(const Cloud& cloud, const std::string& name);

}  // namespace jalon
