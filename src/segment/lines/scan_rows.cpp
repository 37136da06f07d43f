// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/lines/scan_rows.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/error.h"
#include "base/parallel.h"

namespace jalon {

namespace {

constexpr size_t kScanPointsPerChunk = 1 << 15;
constexpr int kStationBits = 40;  // rows of a station count below 2^40
constexpr int kCoarse = 360;  // cells about the horizon, one degree each, for the solid angle seen

uint64_t row_of_station(size_t station, double row) {
  const double most = std::ldexp(1.0, kStationBits) - 1;
  const double whole = row > 0 ? std::min(std::floor(row), most) : 0;  // what is no number is row 0
  return uint64_t{station} << kStationBits | static_cast<uint64_t>(whole);
}

// Which station saw each point: those of the same grid share one number. Without stations all do.
size_t station_number(const Cloud& cloud, size_t point, size_t& last) {
  const auto& stations = cloud.stations;
  if (stations.empty()) return 0;
  const auto holds = [&](size_t s) {
    return point >= stations[s].first && point < stations[s].first + stations[s].count;
  };
  if (last < stations.size() && holds(last)) return last + 1;
  const auto after =
      std::upper_bound(stations.begin(), stations.end(), point,
                       [](size_t p, const Station& station) { return p < station.first; });
  if (after == stations.begin()) return 0;
  const auto found = static_cast<size_t>(after - stations.begin() - 1);
  if (!holds(found)) return 0;
  last = found;
  return found + 1;
}

std::vector<ScanPlace> places_by_fields(const Cloud& cloud, const Column& rows,
                                        const Column& columns, Task& task) {
  std::vector<ScanPlace> places(cloud.size());
  parallel_for(task, cloud.size(), kScanPointsPerChunk, [&](size_t begin, size_t end) {
    size_t last = 0;
    for (size_t i = begin; i < end; ++i) {
      const double column = columns.number(i);
      places[i] = {row_of_station(station_number(cloud, i, last), rows.number(i)),
                   std::isnan(column) ? 0 : column, static_cast<uint32_t>(i)};
    }
  });
  return places;
}

struct Angles {
  double horizontal, vertical;
};
Angles angles_of(const Vec3& seen) {
  return {std::atan2(seen.x, seen.y) + std::numbers::pi,
          std::atan2(seen.z, std::hypot(seen.x, seen.y))};
}

// Mean step of the angles of a station: the root of the solid angle that it saw, a point.
double angular_step(const std::vector<Angles>& angles) {
  std::vector<uint8_t> seen(kCoarse * kCoarse / 2, 0);
  constexpr double kPerRad = kCoarse / (2 * std::numbers::pi);
  double area = 0;
  for (const Angles& a : angles) {
    const auto h = std::min(kCoarse - 1, static_cast<int>(a.horizontal * kPerRad));
    const auto v = std::clamp(static_cast<int>((a.vertical + std::numbers::pi / 2) * kPerRad), 0,
                              kCoarse / 2 - 1);
    auto& cell = seen[static_cast<size_t>(v * kCoarse + h)];
    if (cell == 0) area += std::cos((v + 0.5) / kPerRad - std::numbers::pi / 2);
    cell = 1;
  }
  return std::sqrt(area / (kPerRad * kPerRad) / static_cast<double>(angles.size()));
}

void add_places_by_angles(const Cloud& cloud, size_t station, std::vector<ScanPlace>& places,
                          Task& task) {
  const Station& from = cloud.stations[station];
  const Transform into = inverse(from.pose);
  std::vector<Angles> angles(from.count);
  parallel_for(task, from.count, kScanPointsPerChunk, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i)
      angles[i] = angles_of(into.point(cloud.point(from.first + i)));
  });
  if (angles.empty()) return;
  const double step = angular_step(angles);
  for (size_t i = 0; i < angles.size(); ++i)
    places.push_back({row_of_station(station, angles[i].horizontal / step), angles[i].vertical,
                      static_cast<uint32_t>(from.first + i)});
}

}  // namespace

std::vector<ScanPlace> scan_places(const Cloud& cloud, Task& task) {
  const Column* rows = cloud.fields.find("row");
  const Column* columns = cloud.fields.find("column");
  std::vector<ScanPlace> places;
  if (rows != nullptr && columns != nullptr) {
    places = places_by_fields(cloud, *rows, *columns, task);
  } else {
    for (size_t s = 0; s < cloud.stations.size(); ++s)
      if (cloud.stations[s].has_pose) add_places_by_angles(cloud, s, places, task);
  }
  if (places.empty())
    fail(Status::kUnsupported,
         "scan_lines needs the fields \"row\" and \"column\" or stations with a pose");
  task.checkpoint(0.5);
  std::sort(places.begin(), places.end(), [](const ScanPlace& a, const ScanPlace& b) {
    if (a.row != b.row) return a.row < b.row;
    return a.along != b.along ? a.along < b.along : a.point < b.point;
  });
  return places;
}

}  // namespace jalon
