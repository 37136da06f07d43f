// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/files/station_file.h"

#include <limits>

#include "base/error.h"
#include "formats/files/atomic_file.h"
#include "formats/files/byte_source.h"
#include "formats/files/told_stations.h"

namespace jalon {

namespace {

constexpr uint64_t kMostFileBytes = uint64_t{32} << 20;  // of 65535 stations with long names

std::string base_name(const std::string& path) {
  const size_t slash = path.find_last_of("/\\");
  return slash == std::string::npos ? path : path.substr(slash + 1);
}

ToldStations read_file(const std::string& path) {
  const ByteSource source(path);
  if (source.size() > kMostFileBytes) fail(Status::kFormat, "it has more than 32 MiB");
  std::string text(source.size(), '\0');
  source.read(0, text.data(), text.size());
  ToldStations told;
  read_stations(text, told);
  return told;
}

bool is_there(const std::string& path) { return state_of(path).kind == FileKind::kRegular; }

bool is_of(const ToldStations& told, const std::string& path) {
  return told.file.empty() || told.file == base_name(path);
}

}  // namespace

std::string station_file_of(const std::string& path) {
  const size_t slash = path.find_last_of("/\\");
  const size_t dot = path.rfind('.');
  const bool has_extension =
      dot != std::string::npos && (slash == std::string::npos || dot > slash + 1) && dot > 0;
  return (has_extension ? path.substr(0, dot) : path) + ".stations.json";
}

bool has_station_file(const std::string& path) {
  const std::string beside = station_file_of(path);
  return beside != path && is_there(beside);
}

Cloud with_station_file(Cloud cloud, const std::string& path, bool is_whole, Task& task) {
  const std::string beside = station_file_of(path);
  if (!cloud.stations.empty() || beside == path || !is_there(beside)) return cloud;
  ToldStations told;
  try {
    told = read_file(beside);
  } catch (const Error& error) {
    if (error.status() != Status::kFormat && error.status() != Status::kIo &&
        error.status() != Status::kNotFound)
      throw;
    task.log(Task::kWarning, "%s: the stations are left out: %s", beside.c_str(), error.what());
    return cloud;
  }
  if (!is_of(told, path)) return cloud;
  if (!is_whole && told.field.empty()) {
    task.log(Task::kWarning,
             "%s: the stations are left out: they are ranges of all points, and not all are read",
             beside.c_str());
    return cloud;
  }
  return with_told_stations(std::move(cloud), told, {1, 1, 1}, beside, task);
}

void write_station_file(const Cloud& cloud, const std::string& path, bool is_kept) {
  const std::string beside = station_file_of(path);
  if (beside == path) return;
  if (!cloud.stations.empty() && !is_kept) {
    AtomicFile file(beside);
    file.write(station_texts(cloud, "", {1, 1, 1}, std::numeric_limits<size_t>::max(), 1,
                             base_name(path))[0] +
               "\n");
    file.commit();
    return;
  }
  if (!is_there(beside)) return;
  try {
    if (read_file(beside).file == base_name(path)) remove_file(beside);
  } catch (const Error& error) {
    if (error.status() == Status::kOutOfMemory) throw;  // a file of somebody else stays
  }
}

}  // namespace jalon
