// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/ept/schema.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string_view>

#include "base/parallel.h"
#include "formats/files/endian.h"
#include "formats/files/normal_columns.h"
#include "formats/files/utf8.h"
#include "formats/las/records.h"
#include "formats/las/stations.h"

namespace jalon::ept {

namespace {

constexpr size_t kSchemaGrain = size_t{1} << 16;  // points a chunk
constexpr const char* kAxes[] = {"X", "Y", "Z"};
constexpr size_t kAxisBytes = sizeof(int32_t);

// Names of PDAL's dimensions (pdal.io/dimensions.html), which Entwine writes and viewers look for.
constexpr std::pair<const char*, const char*> kNames[] = {
    {"intensity", "Intensity"},
    {"return_number", "ReturnNumber"},
    {"number_of_returns", "NumberOfReturns"},
    {"scan_direction", "ScanDirectionFlag"},
    {"edge_of_flight_line", "EdgeOfFlightLine"},
    {"classification", "Classification"},
    {"synthetic", "Synthetic"},
    {"key_point", "KeyPoint"},
    {"withheld", "Withheld"},
    {"overlap", "Overlap"},
    {"scanner_channel", "ScanChannel"},
    {"scan_angle", "ScanAngleRank"},
    {"user_data", "UserData"},
    {"point_source_id", "PointSourceId"},
    {"gps_time", "GpsTime"},
    {"red", "Red"},
    {"green", "Green"},
    {"blue", "Blue"},
    {"nir", "Infrared"},
};

std::string known_name(const FieldInfo& info, uint32_t component) {
  if (is_normal(info)) return std::string("Normal") + kAxes[component];
  if (info.components != 1) return numbered(info.name, component);
  for (const auto& [ours, theirs] : kNames)
    if (info.name == ours) return theirs;
  return info.name.empty() ? "field" : info.name;
}

/// Of finite values.
struct Sum {
  uint64_t count = 0;
  double min = std::numeric_limits<double>::infinity();
  double max = -std::numeric_limits<double>::infinity();
  double sum = 0;
  Sum& operator+=(const Sum& b) {
    count += b.count;
    min = std::min(min, b.min);
    max = std::max(max, b.max);
    sum += b.sum;
    return *this;
  }
};

// In chunks whose sums are added up in order: the same bits for any number of threads.
Sum sum_of(const Dimension& dimension, double less, bool squared, Task& task) {
  const Column& column = *dimension.column;
  const size_t stride = column.info().components;
  return visit(column.info().type, [&](auto zero) {
    const auto* from = static_cast<const decltype(zero)*>(column.raw()) + dimension.component;
    return parallel_reduce<Sum>(task, column.count(), kSchemaGrain, {},
                                [&](size_t begin, size_t end) {
                                  Sum out;
                                  for (size_t i = begin; i < end; ++i) {
                                    const auto value = static_cast<double>(from[i * stride]);
                                    if (!std::isfinite(value)) continue;
                                    ++out.count;
                                    out.min = std::min(out.min, value);
                                    out.max = std::max(out.max, value);
                                    out.sum += squared ? (value - less) * (value - less) : value;
                                  }
                                  return out;
                                });
  });
}

void add_statistics(const Dimension& dimension, JsonWriter& json, Task& task) {
  const Sum sum = sum_of(dimension, 0, false, task);
  if (sum.count == 0) return;
  const auto n = static_cast<double>(sum.count);
  const double mean = sum.sum / n;
  const double variance = sum_of(dimension, mean, true, task).sum / n;
  json.name("count").value(sum.count).name("minimum").value(sum.min);
  json.name("maximum").value(sum.max).name("mean").value(mean);
  json.name("stddev").value(std::sqrt(variance)).name("variance").value(variance);
}

struct Counts {
  std::array<uint64_t, 256> of{};
  Counts& operator+=(const Counts& b) {
    for (size_t k = 0; k < of.size(); ++k) of[k] += b.of[k];
    return *this;
  }
};

// Of classes, for the legend of viewers.
void add_counts(const Dimension& dimension, JsonWriter& json, Task& task) {
  const auto values = dimension.column->values<uint8_t>();
  const Counts counts =
      parallel_reduce<Counts>(task, values.size(), kSchemaGrain, {}, [&](size_t begin, size_t end) {
        Counts out;
        for (size_t i = begin; i < end; ++i) ++out.of[values[i]];
        return out;
      });
  json.name("counts").begin_array();
  for (size_t k = 0; k < counts.of.size(); ++k)
    if (counts.of[k] != 0)
      json.begin_object().name("value").value(k).name("count").value(counts.of[k]).end_object();
  json.end_array();
}

}  // namespace

const char* kind_of(ElementType type) {
  if (is_floating(type)) return "float";
  return static_cast<int32_t>(type) % 2 == 1 ? "signed"
                                             : "unsigned";  // the numbers of jalon/types.h
}

std::string field_of(const std::string& dimension) {
  for (const auto& [ours, theirs] : kNames)
    if (dimension == theirs) return ours;
  return dimension;
}

Schema make_schema(const Cloud& cloud, const std::string& path, const WriteSettings& settings,
                   Task& task) {
  Schema out;
  out.steps = las::plan_of_steps(cloud, path, settings.scale, task);
  out.record_bytes = std::size(kAxes) * kAxisBytes;
  UniqueNames unique;
  for (const char* axis : kAxes) unique.add(axis);
  const auto add = [&](const ColumnPtr& column) {
    const FieldInfo& info = column->info();
    for (uint32_t c = 0; c < info.components; ++c) {
      out.dimensions.push_back(
          {unique.add(valid_utf8(known_name(info, c))), column, c, out.record_bytes});
      out.record_bytes += size_of(info.type);
    }
  };
  for (const ColumnPtr& column : cloud.fields) add(column);
  if (const ColumnPtr station = las::station_column(cloud, task); station != nullptr) {
    add(station);
    out.station = out.dimensions.back().name;
  }
  return out;
}

void put_records(const Schema& schema, const Cloud& cloud, std::span<const uint32_t> points,
                 std::byte* to) {
  const std::span<const double> xyz = cloud.xyz();
  const size_t stride = schema.record_bytes;
  for (size_t i = 0; i < points.size(); ++i)
    for (size_t k = 0; k < std::size(kAxes); ++k)
      store<int32_t>(
          to + i * stride + k * kAxisBytes,
          las::steps_of(schema.steps, xyz[3 * size_t{points[i]} + k], static_cast<int>(k)));
  for (const Dimension& dimension : schema.dimensions) {
    const FieldInfo& info = dimension.column->info();
    visit(info.type, [&](auto zero) {
      using T = decltype(zero);
      const T* from = static_cast<const T*>(dimension.column->raw()) + dimension.component;
      for (size_t i = 0; i < points.size(); ++i)
        store<T>(to + i * stride + dimension.offset, from[size_t{points[i]} * info.components]);
    });
  }
}

void add_schema(const Schema& schema, JsonWriter& json, Task& task) {
  json.begin_array();
  for (int k = 0; k < 3; ++k)
    json.begin_object()
        .name("name")
        .value(kAxes[k])
        .name("type")
        .value("signed")
        .name("size")
        .value(kAxisBytes)
        .name("scale")
        .value(schema.steps.scale[k])
        .name("offset")
        .value(schema.steps.offset[k])
        .end_object();
  for (const Dimension& dimension : schema.dimensions) {
    const ElementType type = dimension.column->info().type;
    json.begin_object().name("name").value(dimension.name);
    json.name("type").value(kind_of(type)).name("size").value(size_of(type));
    add_statistics(dimension, json, task);
    if (dimension.name == "Classification" && type == ElementType::kUint8)
      add_counts(dimension, json, task);
    json.end_object();
  }
  json.end_array();
}

}  // namespace jalon::ept
