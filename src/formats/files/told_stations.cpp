// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/files/told_stations.h"

#include <algorithm>
#include <map>

#include "base/error.h"
#include "formats/files/growing_cloud.h"

namespace jalon {

namespace {

constexpr double kRigidWithin = 1e-3;  // a rotation told with few digits is one

[[noreturn]] void refuse_stations(const char* why) { fail(Status::kFormat, "%s", why); }

void require_ranges(const ToldStations& told, uint64_t points) {
  uint64_t end = 0;
  for (const auto& [station, value] : told.stations) {
    if (station.first < end) refuse_stations("their ranges overlap or are not in order");
    if (station.first > points || station.count > points - station.first)
      refuse_stations("a range goes beyond the points");
    end = station.first + station.count;
  }
}

void scale_poses(ToldStations& told, const Vec3& metres) {
  for (auto& [station, value] : told.stations) {
    if (!station.has_pose) continue;
    if (!make_rigid(station.pose, kRigidWithin)) refuse_stations("a pose is no rigid motion");
    for (int k = 0; k < 3; ++k) station.pose.m[static_cast<size_t>(4 * k + 3)] *= metres[k];
  }
}

// Which station each point is of: an index, or that of none.
std::vector<uint32_t> owners_of(const Column& field, const ToldStations& told, Task& task) {
  constexpr size_t kOwnersTick = size_t{1} << 16;
  const auto none = static_cast<uint32_t>(told.stations.size());
  std::map<double, uint32_t> by_value;
  for (uint32_t k = 0; k < none; ++k)
    if (!by_value.emplace(told.stations[k].value, k).second)
      refuse_stations("two of them have one value of the field");
  std::vector<uint32_t> owners(field.count(), none);
  double last = 0;
  uint32_t owner = none;
  for (size_t i = 0; i < owners.size(); ++i) {
    if (i % kOwnersTick == 0) task.checkpoint(0);
    const double value = field.number(i);
    if (i == 0 || value != last) {
      const auto found = by_value.find(value);
      owner = found == by_value.end() ? none : found->second;
      last = value;
    }
    owners[i] = owner;
  }
  return owners;
}

bool is_in_runs(const std::vector<uint32_t>& owners, uint32_t none) {
  std::vector<uint8_t> seen(size_t{none} + 1, 0);
  for (size_t i = 0; i < owners.size(); ++i) {
    if (i > 0 && owners[i] == owners[i - 1]) continue;
    if (owners[i] != none && seen[owners[i]]++ != 0) return false;
  }
  return true;
}

std::vector<Station> runs_of(const std::vector<uint32_t>& owners, const ToldStations& told) {
  std::vector<Station> out;
  for (size_t i = 0; i < owners.size(); ++i) {
    if (owners[i] >= told.stations.size()) continue;
    if (i == 0 || owners[i] != owners[i - 1]) {
      out.push_back(told.stations[owners[i]].station);
      out.back().first = i;
      out.back().count = 0;
    }
    ++out.back().count;
  }
  return out;
}

Cloud by_field(Cloud cloud, const ToldStations& told, const std::string& path, Task& task) {
  const Column* field = cloud.fields.find(told.field);
  if (field == nullptr || field->info().components != 1)
    refuse_stations("the points have no field of the name that tells them apart");
  std::vector<uint32_t> owners = owners_of(*field, told, task);
  const auto none = static_cast<uint32_t>(told.stations.size());
  if (!is_in_runs(owners, none)) {
    task.log(Task::kWarning, "%s: the points are put in the order of their stations", path.c_str());
    std::vector<uint64_t> order(owners.size());
    for (size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::ranges::stable_sort(order, [&](uint64_t a, uint64_t b) { return owners[a] < owners[b]; });
    cloud = select(cloud, order, task);
    std::ranges::sort(owners);
  }
  cloud.stations = runs_of(owners, told);
  return cloud;
}

}  // namespace

Cloud with_told_stations(Cloud cloud, const ToldStations& told, const Vec3& metres,
                         const std::string& path, Task& task) {
  if (told.stations.empty()) return cloud;
  try {
    ToldStations scaled = told;
    scale_poses(scaled, metres);
    if (!told.field.empty()) return by_field(cloud, scaled, path, task);
    if (told.points && *told.points != cloud.size())
      refuse_stations("they are of another number of points");
    require_ranges(scaled, cloud.size());
    for (auto& [station, value] : scaled.stations) cloud.stations.push_back(station);
  } catch (const Error& error) {
    if (error.status() != Status::kFormat) throw;
    task.log(Task::kWarning, "%s: the stations are left out: %s", path.c_str(), error.what());
  }
  return cloud;
}

std::shared_ptr<Column> station_numbers(const Cloud& cloud, const std::string& name) {
  constexpr size_t kMostBytes = 0xFF, kMostWords = 0xFFFF;
  if (cloud.stations.size() > kMostWords) return nullptr;
  const auto numbered_as = [&](auto zero) {
    using T = decltype(zero);
    auto out = std::make_shared<Column>(
        FieldInfo{name, element_type_of<T>(), 1, "", "number of the station, 0: none"},
        cloud.size());
    const std::span<T> values = out->template values<T>();
    std::ranges::fill(values, T{0});
    T number = 0;
    for (const Station& s : cloud.stations)
      std::fill_n(values.begin() + static_cast<ptrdiff_t>(s.first), s.count, ++number);
    return out;
  };
  return cloud.stations.size() <= kMostBytes ? numbered_as(uint8_t{}) : numbered_as(uint16_t{});
}

}  // namespace jalon
