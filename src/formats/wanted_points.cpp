// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/wanted_points.h"

#include <algorithm>
#include <bit>
#include <numeric>
#include <string>
#include <utility>

#include "base/error.h"
#include "base/text_number.h"
#include "cloud/operations.h"

namespace jalon {

namespace {

constexpr const char* kNoFields = "-";

/// A field that the option "fields" names; "intensity?" may be missing.
struct WantedField {
  std::string name;
  bool may_miss = false;
};

std::vector<WantedField> fields_of(const std::string& text) {
  std::vector<WantedField> out;
  for (size_t at = 0; at < text.size();) {
    const size_t end = std::min(text.find_first_of(" ,", at), text.size());
    const bool may_miss = end > at + 1 && text[end - 1] == '?';
    if (end > at) out.push_back({text.substr(at, end - at - (may_miss ? 1 : 0)), may_miss});
    at = end + 1;
  }
  return out;
}

Cloud within_box(Cloud cloud, const ReadSettings& settings, Task& task) {
  if (settings.box.empty()) return cloud;
  const std::vector<uint8_t> mask = inside_box(cloud, settings.box_m(), Transform{}, task);
  if (std::ranges::find(mask, 0) == mask.end()) return cloud;
  return select_mask(cloud, mask, 1, task);
}

const Station& station_told(const Cloud& cloud, const std::string& told, const std::string& path) {
  std::string names, numbers;
  const Station* named = nullptr;
  int named_so = 0, last = 0, place = 0;
  for (const Station& station : cloud.stations) {
    ++place;
    names += (names.empty() ? "" : ", ") + station.name.str();
    if (station.name.str() != told) continue;
    if (named_so++ > 0) numbers += (numbers.empty() ? "" : ", ") + std::to_string(last);
    named = &station;
    last = place;
  }
  if (named_so == 1) return *named;
  // Files that were joined: the points of one of them would be lost without a word.
  if (named_so > 1)
    fail(Status::kInvalidArgument,
         "%.400s: %d stations are named \"%.200s\": their numbers tell them apart, %.600s or %d",
         path.c_str(), named_so, told.c_str(), numbers.c_str(), last);
  int64_t number = 0;
  if (parse_integer(told, number) && number >= 1 &&
      static_cast<uint64_t>(number) <= cloud.stations.size())
    return cloud.stations[static_cast<size_t>(number - 1)];
  if (names.empty())
    fail(Status::kNotFound, "%.400s: no station \"%.200s\": the points that were read have none",
         path.c_str(), told.c_str());
  fail(Status::kNotFound, "%.400s: no station \"%.200s\"; there are: %.600s", path.c_str(),
       told.c_str(), names.c_str());
}

Cloud of_station(Cloud cloud, const std::string& path, const ReadSettings& settings, Task& task) {
  if (settings.station.empty()) return cloud;
  const Station& station = station_told(cloud, settings.station, path);
  std::vector<uint64_t> indices(station.count);
  std::iota(indices.begin(), indices.end(), station.first);
  return select(cloud, indices, task);
}

// Point i of those kept, floor(i all / kept) of all of them.
uint64_t kept_point(uint64_t i, uint64_t all, uint64_t kept) {
  return i * (all / kept) + i * (all % kept) / kept;
}

// The points [first, first + count) of all that are kept, less first.
Cloud evenly(Cloud piece, uint64_t first, uint64_t all, const ReadSettings& settings, Task& task) {
  const auto kept = static_cast<uint64_t>(settings.max_points);
  if (kept == 0 || all <= kept) return piece;
  std::vector<uint64_t> indices;
  uint64_t i = 0;
  for (uint64_t step = std::bit_floor(kept); step > 0; step /= 2)
    if (i + step <= kept && kept_point(i + step - 1, all, kept) < first) i += step;
  for (; i < kept && kept_point(i, all, kept) < first + piece.size(); ++i)
    indices.push_back(kept_point(i, all, kept) - first);
  return select(piece, indices, task);
}

[[noreturn]] void refuse_field(const Cloud& cloud, const std::string& name,
                               const std::string& path) {
  std::string names;
  for (const ColumnPtr& column : cloud.fields)
    names += (names.empty() ? "" : ", ") + column->info().name;
  fail(Status::kNotFound, "%.400s: no field \"%.200s\"; there are: %.600s", path.c_str(),
       name.c_str(), names.empty() ? "none" : names.c_str());
}

Cloud with_wanted_fields(Cloud cloud, const std::string& path, const ReadSettings& settings) {
  if (settings.fields.empty()) return cloud;
  FieldTable kept;
  if (settings.fields != kNoFields)
    for (const auto& [name, may_miss] : fields_of(settings.fields)) {
      ColumnPtr field = cloud.fields.find_shared(name);
      if (field == nullptr && !may_miss) refuse_field(cloud, name, path);
      if (field != nullptr) kept.set(std::move(field));
    }
  cloud.fields = std::move(kept);
  return cloud;
}

}  // namespace

bool wants_field(const ReadSettings& settings, std::string_view name) {
  return settings.fields.empty() ||
         std::ranges::count(fields_of(settings.fields), name, &WantedField::name) != 0;
}

bool wants_only(const ReadSettings& settings, const std::vector<std::string>& names) {
  return settings.fields == kNoFields ||
         std::ranges::all_of(fields_of(settings.fields), [&](const WantedField& field) {
           return field.may_miss || std::ranges::count(names, field.name) != 0;
         });
}

Cloud wanted_points(Cloud piece, uint64_t first, uint64_t all, const std::string& path,
                    const ReadSettings& settings, Task& task) {
  piece = evenly(within_box(std::move(piece), settings, task), first, all, settings, task);
  return with_wanted_fields(std::move(piece), path, settings);
}

Cloud wanted_points(Cloud cloud, const std::string& path, const ReadSettings& settings,
                    Task& task) {
  cloud = of_station(within_box(std::move(cloud), settings, task), path, settings, task);
  const size_t all = cloud.size();
  return with_wanted_fields(evenly(std::move(cloud), 0, all, settings, task), path, settings);
}

}  // namespace jalon
