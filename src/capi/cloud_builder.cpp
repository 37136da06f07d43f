// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <cstring>
#include <new>
#include <vector>

#include "capi/support/cloud_handle.h"
#include "cloud/select.h"

namespace jalon::capi {

namespace {

/// A declared field and the bytes of its items so far, packed.
struct GrowingField {
  FieldInfo info;
  std::vector<std::byte> bytes;
  size_t item_bytes() const { return size_of(info.type) * info.components; }
  size_t count() const { return bytes.size() / item_bytes(); }
};

struct Draft {
  std::vector<double> xyz;
  std::vector<GrowingField> fields;
  std::vector<Station> stations;
  SharedText crs;

  size_t size() const { return xyz.size() / 3; }
  GrowingField& require(const std::string& name) {
    std::string names;
    for (GrowingField& field : fields) {
      if (field.info.name == name) return field;
      names += (names.empty() ? "" : ", ") + field.info.name;
    }
    fail(Status::kNotFound, "no field \"%s\" is declared; there are: %s", name.c_str(),
         names.empty() ? "none" : names.c_str());
  }
};

Cloud cloud_of(const Draft& draft) {
  for (const GrowingField& field : draft.fields)
    if (field.count() != draft.size())
      fail(Status::kInvalidArgument, "field \"%s\" has %zu items for %zu points",
           field.info.name.c_str(), field.count(), draft.size());
  Buffer<double> xyz(draft.xyz.size());
  if (!draft.xyz.empty())
    std::memcpy(xyz.data(), draft.xyz.data(), draft.xyz.size() * sizeof(double));
  Cloud cloud = make_cloud(std::move(xyz));
  for (const GrowingField& field : draft.fields) {
    auto column = std::make_shared<Column>(field.info, draft.size());
    if (!field.bytes.empty()) std::memcpy(column->raw(), field.bytes.data(), field.bytes.size());
    cloud.fields.set(std::move(column));
  }
  cloud.stations = draft.stations;
  for (size_t i = 0; i < cloud.stations.size(); ++i) {
    const uint64_t end = i + 1 < cloud.stations.size() ? cloud.stations[i + 1].first : cloud.size();
    cloud.stations[i].count = end - cloud.stations[i].first;
  }
  cloud.crs = draft.crs;
  return cloud;
}

}  // namespace

}  // namespace jalon::capi

struct jalon_cloud_builder : jalon::capi::Counted {
  bool drop_invalid = false;
  jalon::capi::Draft draft;
};

using namespace jalon;
using namespace jalon::capi;

jalon_status jalon_cloud_builder_create(uint32_t flags, jalon_cloud_builder** out) {
  return guard([&] {
    require(out, "out");
    const bool drop = require_flags(flags);
    auto handle = std::make_unique<jalon_cloud_builder>();
    handle->drop_invalid = drop;
    *out = handle.release();
  });
}

jalon_cloud_builder* jalon_cloud_builder_retain(jalon_cloud_builder* builder) {
  return retain(builder);
}
void jalon_cloud_builder_release(jalon_cloud_builder* builder) { release(builder); }

jalon_status jalon_cloud_builder_set_crs(jalon_cloud_builder* builder, const char* crs) {
  return guard([&] {
    require(builder, "builder");
    builder->draft.crs = require_text(crs, "crs", kLongText);
  });
}

jalon_status jalon_cloud_builder_declare_field(jalon_cloud_builder* builder, const char* name,
                                               int32_t type, uint32_t components, const char* unit,
                                               const char* meaning) {
  return guard([&] {
    require(builder, "builder");
    FieldInfo info = require_field_info(name, type, components, unit, meaning);
    for (const GrowingField& field : builder->draft.fields)
      if (field.info.name == info.name)
        fail(Status::kInvalidArgument, "field \"%s\" is already declared", info.name.c_str());
    builder->draft.fields.push_back({std::move(info), {}});
  });
}

jalon_status jalon_cloud_builder_begin_station(jalon_cloud_builder* builder, const char* name,
                                               const jalon_transform* pose) {
  return guard([&] {
    require(builder, "builder");
    Station station;
    station.name = require_text(name, "name");
    station.has_pose = pose != nullptr;
    if (pose != nullptr) station.pose = require_pose(*pose);
    station.first = builder->draft.size();
    builder->draft.stations.push_back(std::move(station));
  });
}

jalon_status jalon_cloud_builder_append_points(jalon_cloud_builder* builder, const void* xyz,
                                               int32_t type, uint64_t count,
                                               uint64_t stride_bytes) {
  return guard([&] {
    require(builder, "builder");
    const size_t stride = require_array(xyz, type, count, 3, stride_bytes, "xyz");
    auto& all = builder->draft.xyz;
    const size_t before = all.size();
    if (count > (all.max_size() - before) / 3) throw std::bad_alloc();
    all.resize(before + 3 * count);
    try {
      load_coordinates(xyz, require_type(type), count, stride, all.data() + before);
      if (builder->drop_invalid) return;
      for (size_t i = before; i < all.size(); ++i)
        if (!std::isfinite(all[i])) require_finite(all);  // throws and names the point
    } catch (...) {
      all.resize(before);
      throw;
    }
  });
}

jalon_status jalon_cloud_builder_append_field(jalon_cloud_builder* builder, const char* name,
                                              const void* data, int32_t type, uint64_t count,
                                              uint64_t stride_bytes) {
  return guard([&] {
    require(builder, "builder");
    GrowingField& field = builder->draft.require(require_text(name, "name"));
    const size_t stride =
        require_array(data, type, count, field.info.components, stride_bytes, "data");
    if (count == 0) return;
    Column block(field.info, count);
    store_converted(block, 0, data, require_type(type), count, stride);
    const auto* from = static_cast<const std::byte*>(block.raw());
    field.bytes.insert(field.bytes.end(), from, from + block.bytes());
  });
}

jalon_status jalon_cloud_builder_seal(jalon_cloud_builder* builder, jalon_cloud** out) {
  return guard([&] {
    require(builder, "builder");
    require(out, "out");
    Cloud cloud = cloud_of(builder->draft);
    if (builder->drop_invalid) {
      const std::vector<uint64_t> kept = finite_points(cloud.xyz());
      with_task(nullptr, [&](Task& task) { cloud = select_kept(cloud, kept, task); });
    }
    *out = new_cloud(std::move(cloud));
    builder->draft = Draft();
  });
}
