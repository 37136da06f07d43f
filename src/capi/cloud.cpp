// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "jalon/cloud.h"

#include <cmath>
#include <cstring>
#include <limits>
#include <new>

#include "base/large_memory.h"
#include "capi/support/cloud_handle.h"

namespace jalon::capi {

FieldInfo require_field_info(const char* name, int32_t type, uint32_t components, const char* unit,
                             const char* meaning) {
  constexpr size_t kMaxName = 255;
  FieldInfo info;
  info.name = require_text(name, "name", kMaxName);
  if (info.name.empty()) fail(Status::kInvalidArgument, "the name of a field is empty");
  info.type = require_type(type);
  if (components == 0 || components > kMostComponents)
    fail(Status::kInvalidArgument, "field \"%s\": %u components; 1 ... %u are possible",
         info.name.c_str(), components, kMostComponents);
  info.components = components;
  if (unit != nullptr) info.unit = require_text(unit, "unit");
  if (meaning != nullptr) info.meaning = require_text(meaning, "meaning");
  return info;
}

bool require_flags(uint32_t flags) {
  if ((flags & ~uint32_t{JALON_CLOUD_DROP_INVALID}) != 0)
    fail(Status::kInvalidArgument, "flags %u hold an unknown bit", flags);
  return (flags & JALON_CLOUD_DROP_INVALID) != 0;
}

void load_coordinates(const void* xyz, ElementType type, size_t count, size_t stride_bytes,
                      double* out) {
  const auto* from = static_cast<const char*>(xyz);
  if (type == ElementType::kFloat64 && stride_bytes == 3 * sizeof(double)) {
    if (count != 0) std::memcpy(out, from, count * stride_bytes);
    return;
  }
  visit(type, [&](auto zero) {
    using T = decltype(zero);
    for (size_t i = 0; i < count; ++i) {
      T values[3];
      std::memcpy(values, from + i * stride_bytes,
                  sizeof values);  // the caller's memory need not be aligned
      for (size_t c = 0; c < 3; ++c) out[3 * i + c] = static_cast<double>(values[c]);
    }
  });
}

std::vector<uint64_t> finite_points(std::span<const double> xyz) {
  std::vector<uint64_t> indices;
  indices.reserve(xyz.size() / 3);
  for (size_t i = 0; i < xyz.size() / 3; ++i)
    if (std::isfinite(xyz[3 * i]) && std::isfinite(xyz[3 * i + 1]) && std::isfinite(xyz[3 * i + 2]))
      indices.push_back(i);
  return indices;
}

namespace {

/// Refuses the points that are not finite, or leaves them out.
Cloud checked_cloud(Buffer<double> xyz, bool drop) {
  const std::span<const double> values(xyz.data(), xyz.size());
  if (!drop) {
    require_finite(values);
    return make_cloud(std::move(xyz));
  }
  const std::vector<uint64_t> kept = finite_points(values);
  if (3 * kept.size() == xyz.size()) return make_cloud(std::move(xyz));
  Buffer<double> packed(3 * kept.size());
  for (size_t i = 0; i < kept.size(); ++i)
    for (size_t c = 0; c < 3; ++c) packed[3 * i + c] = xyz[3 * kept[i] + c];
  return make_cloud(std::move(packed));
}

void require_no_overflow(uint64_t count) {
  if (count > std::numeric_limits<size_t>::max() / 48) throw std::bad_alloc();
}

}  // namespace

}  // namespace jalon::capi

using namespace jalon;
using namespace jalon::capi;

jalon_status jalon_cloud_create(const void* xyz, int32_t type, uint64_t count,
                                uint64_t stride_bytes, uint32_t flags, jalon_cloud** out) {
  return guard([&] {
    require(out, "out");
    const bool drop = require_flags(flags);
    const size_t stride = require_array(xyz, type, count, 3, stride_bytes, "xyz");
    require_no_overflow(count);
    Buffer<double> coordinates(3 * count);
    const bool large = coordinates.size() * sizeof(double) >= kLargeBytes;
    // The usual large array, packed doubles: looked at while they are copied, so that they cross the memory bus once.
    if (large && require_type(type) == ElementType::kFloat64 && stride == 3 * sizeof(double) &&
        copy_finite(xyz, 3 * count, coordinates.data())) {
      *out = new_cloud(make_cloud(std::move(coordinates)));
      return;
    }
    load_coordinates(xyz, require_type(type), count, stride, coordinates.data());
    *out = new_cloud(checked_cloud(std::move(coordinates), drop));
  });
}

jalon_status jalon_cloud_create_columns(const void* x, const void* y, const void* z, int32_t type,
                                        uint64_t count, uint64_t stride_bytes, uint32_t flags,
                                        jalon_cloud** out) {
  return guard([&] {
    require(out, "out");
    const bool drop = require_flags(flags);
    const void* columns[3] = {x, y, z};
    const char* names[3] = {"x", "y", "z"};
    size_t stride = 0;
    for (size_t c = 0; c < 3; ++c)
      stride = require_array(columns[c], type, count, 1, stride_bytes, names[c]);
    require_no_overflow(count);
    Buffer<double> coordinates(3 * count);
    visit(require_type(type), [&](auto zero) {
      using T = decltype(zero);
      for (size_t i = 0; i < count;
           ++i)  // point by point, so that the result crosses the memory bus once
        for (size_t c = 0; c < 3; ++c) {
          T value;
          std::memcpy(&value, static_cast<const char*>(columns[c]) + i * stride, sizeof value);
          coordinates[3 * i + c] = static_cast<double>(value);
        }
    });
    *out = new_cloud(checked_cloud(std::move(coordinates), drop));
  });
}

jalon_status jalon_cloud_copy(const jalon_cloud* cloud, jalon_cloud** out) {
  return guard([&] {
    require(cloud, "cloud");
    require(out, "out");
    *out = new_cloud(*cloud->cloud);
  });
}

jalon_cloud* jalon_cloud_retain(jalon_cloud* cloud) { return retain(cloud); }
void jalon_cloud_release(jalon_cloud* cloud) { release(cloud); }

jalon_status jalon_cloud_count(const jalon_cloud* cloud, uint64_t* out) {
  return guard([&] {
    require(cloud, "cloud");
    require(out, "out");
    *out = cloud->cloud->size();
  });
}

jalon_status jalon_cloud_points(const jalon_cloud* cloud, jalon_array_view* out) {
  return guard([&] {
    require(cloud, "cloud");
    require(out, "out");
    *out = {cloud->cloud->xyz_buffer->data(), cloud->cloud->size(), 3, JALON_FLOAT64,
            3 * sizeof(double)};
  });
}

jalon_status jalon_cloud_fields(const jalon_cloud* cloud, jalon_fields** out) {
  return give_fields(cloud, "cloud", out, [&] { return cloud->cloud->fields; });
}

jalon_status jalon_cloud_bounds(const jalon_cloud* cloud, jalon_box* out) {
  return guard([&] {
    require(cloud, "cloud");
    require(out, "out");
    if (cloud->cloud->size() == 0)
      fail(Status::kInsufficientData, "the cloud is empty: it has no bounds");
    const Box3 box = with_task(nullptr, [&](Task& task) { return bounds(*cloud->cloud, task); });
    *out = {to_c(box.min), to_c(box.max)};
  });
}

jalon_status jalon_cloud_crs(const jalon_cloud* cloud, const char** out) {
  return guard([&] {
    require(cloud, "cloud");
    require(out, "out");
    *out = cloud->cloud->crs.c_str();
  });
}

jalon_status jalon_cloud_set_crs(jalon_cloud* cloud, const char* crs) {
  return guard([&] {
    require(cloud, "cloud");
    Cloud changed = *cloud->cloud;
    changed.crs = require_text(crs, "crs", kLongText);
    replace(cloud, std::move(changed));
  });
}

jalon_status jalon_cloud_station_count(const jalon_cloud* cloud, uint64_t* out) {
  return guard([&] {
    require(cloud, "cloud");
    require(out, "out");
    *out = cloud->cloud->stations.size();
  });
}

jalon_status jalon_cloud_station(const jalon_cloud* cloud, uint64_t i, const char** name,
                                 int32_t* has_pose, jalon_transform* pose, uint64_t* first,
                                 uint64_t* count) {
  return guard([&] {
    require(cloud, "cloud");
    const auto& stations = cloud->cloud->stations;
    if (i >= stations.size())
      fail(Status::kInvalidArgument, "station %llu; there are %zu",
           static_cast<unsigned long long>(i), stations.size());
    const Station& station = stations[i];
    if (name != nullptr) *name = station.name.c_str();
    if (has_pose != nullptr) *has_pose = station.has_pose ? 1 : 0;
    if (pose != nullptr) *pose = to_c(station.pose);
    if (first != nullptr) *first = station.first;
    if (count != nullptr) *count = station.count;
  });
}

jalon_status jalon_cloud_set_station(jalon_cloud* cloud, const char* name,
                                     const jalon_transform* pose) {
  return guard([&] {
    require(cloud, "cloud");
    Station station;
    station.name = require_text(name, "name");
    station.has_pose = pose != nullptr;
    if (pose != nullptr) station.pose = require_pose(*pose);
    station.count = cloud->cloud->size();
    Cloud changed = *cloud->cloud;
    changed.stations.assign(1, station);
    replace(cloud, std::move(changed));
  });
}

jalon_status jalon_cloud_set_field(jalon_cloud* cloud, const char* name, const void* data,
                                   int32_t type, uint32_t components, uint64_t count,
                                   uint64_t stride_bytes, const char* unit, const char* meaning) {
  return guard([&] {
    require(cloud, "cloud");
    FieldInfo info = require_field_info(name, type, components, unit, meaning);
    const size_t stride = require_array(data, type, count, components, stride_bytes, "data");
    if (count != cloud->cloud->size())
      fail(Status::kInvalidArgument, "field \"%s\" has %llu items; the cloud has %zu points",
           info.name.c_str(), static_cast<unsigned long long>(count), cloud->cloud->size());
    auto column = std::make_shared<Column>(std::move(info), count);
    store_converted(*column, 0, data, column->info().type, count, stride);
    Cloud changed = *cloud->cloud;
    changed.fields.set(std::move(column));
    replace(cloud, std::move(changed));
  });
}

jalon_status jalon_cloud_remove_field(jalon_cloud* cloud, const char* name) {
  return guard([&] {
    require(cloud, "cloud");
    const std::string text = require_text(name, "name");
    cloud->cloud->fields.require(text);
    Cloud changed = *cloud->cloud;
    changed.fields.remove(text);
    replace(cloud, std::move(changed));
  });
}

jalon_status jalon_cloud_prepare(const jalon_cloud* cloud, jalon_task* task) {
  return guard([&] {
    require(cloud, "cloud");
    with_task(task, [&](Task& t) { cloud->cloud->octree(t); });
  });
}

jalon_status jalon_cloud_drop_index(const jalon_cloud* cloud) {
  return guard([&] {
    require(cloud, "cloud");
    cloud->cloud->index->drop();
  });
}
