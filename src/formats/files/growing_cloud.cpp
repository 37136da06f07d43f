// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/files/growing_cloud.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "base/parallel.h"
#include "geometry/rotation.h"

namespace jalon {

namespace {

template <class T>
T stored_as(double value) {
  if constexpr (std::is_floating_point_v<T>) {
    return static_cast<T>(value);
  } else {
    const double nearest = std::nearbyint(value);
    constexpr T kLeast = std::numeric_limits<T>::lowest(), kMost = std::numeric_limits<T>::max();
    // The most of 64 bits is no double: the next one is beyond it.
    if (nearest >= static_cast<double>(kMost)) return kMost;
    if (nearest <= static_cast<double>(kLeast)) return kLeast;
    return std::isnan(nearest) ? T{} : static_cast<T>(nearest);
  }
}

}  // namespace

GrowingColumn::GrowingColumn(FieldInfo info, size_t before) : info_(std::move(info)) {
  for (size_t i = 0; i < before; ++i) add_none();
}

void GrowingColumn::extend(size_t count) {
  size_ += count;
  while (size_ > blocks_.size() * kBlockItems)
    blocks_.push_back(
        std::make_unique_for_overwrite<std::byte[]>(kBlockItems * size_of(info_.type)));
}

void GrowingColumn::put(size_t first, std::span<const double> values) {
  visit(info_.type, [&](auto zero) {
    using T = decltype(zero);
    while (!values.empty()) {
      const size_t inside = first % kBlockItems;
      const size_t count = std::min(values.size(), kBlockItems - inside);
      std::byte* const to = blocks_[first / kBlockItems].get() + inside * sizeof(T);
      for (size_t i = 0; i < count; ++i) {
        const T value = stored_as<T>(values[i]);
        std::memcpy(to + i * sizeof(T), &value, sizeof(T));
      }
      values = values.subspan(count);
      first += count;
    }
  });
}

void GrowingColumn::add(double value) {
  extend(1);
  put(size_ - 1, {&value, 1});
}

void GrowingColumn::add_none() {
  add(is_floating(info_.type) ? std::numeric_limits<double>::quiet_NaN() : 0);
}

void GrowingColumn::move_to(void* out, Task& task) {
  const size_t bytes = size_of(info_.type);
  parallel_chunks(task, blocks_.size(), [&](size_t b) {
    const size_t first = b * kBlockItems;
    std::memcpy(static_cast<std::byte*>(out) + first * bytes, blocks_[b].get(),
                std::min(kBlockItems, size_ - first) * bytes);
    blocks_[b].reset();
  });
  blocks_.clear();
  size_ = 0;
}

GrowingCloud::GrowingCloud() : x_({"xyz", ElementType::kFloat64, 1, "", ""}, 0) {}

size_t GrowingCloud::field(const FieldInfo& info) {
  for (size_t i = 0; i < fields_.size(); ++i)
    if (fields_[i].info().name == info.name) return i;
  fields_.emplace_back(info, size());
  return fields_.size() - 1;
}

void GrowingCloud::begin_station(const std::string& name, const Transform* pose) {
  Station station;
  station.name = name;
  station.has_pose = pose != nullptr;
  if (pose != nullptr) station.pose = *pose;
  station.first = size();
  stations_.push_back(station);
}

void GrowingCloud::add(const Vec3& point, std::span<const size_t> numbers,
                       std::span<const double> values) {
  for (int k = 0; k < 3; ++k) x_.add(point[k]);
  for (size_t i = 0; i < numbers.size(); ++i) fields_[numbers[i]].add(values[i]);
  for (GrowingColumn& field : fields_)
    if (field.size() < size()) field.add_none();
  if (!stations_.empty()) ++stations_.back().count;
}

size_t GrowingCloud::extend(size_t count, std::span<const size_t> numbers) {
  const size_t first = size();
  x_.extend(3 * count);
  for (const size_t number : numbers) fields_[number].extend(count);
  for (GrowingColumn& field : fields_)
    while (field.size() < size()) field.add_none();
  if (!stations_.empty()) stations_.back().count += count;
  return first;
}

Cloud GrowingCloud::finish(Task& task) {
  const size_t count = size();
  Buffer<double> xyz(3 * count);
  x_.move_to(xyz.data(), task);
  Cloud cloud = make_cloud(std::move(xyz));
  for (GrowingColumn& field : fields_) {
    auto column = std::make_shared<Column>(field.info(), count);
    field.move_to(column->raw(), task);
    cloud.fields.set(std::move(column));
  }
  cloud.stations = std::move(stations_);
  return cloud;
}

bool make_rigid(Transform& pose, double tolerance) {
  for (const double value : pose.m)
    if (!std::isfinite(value)) return false;
  const auto& m = pose.m;
  Quaternion q = quaternion_of({{m[0], m[1], m[2], m[4], m[5], m[6], m[8], m[9], m[10]}});
  const double length = std::sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
  if (!(length > 0)) return false;
  const Matrix3 near = matrix_of({q.w / length, q.x / length, q.y / length, q.z / length});
  double off = 0;
  for (size_t i = 0; i < 9; ++i) off = std::max(off, std::fabs(near.m[i] - m[4 * (i / 3) + i % 3]));
  if (!(off <= tolerance)) return false;
  for (size_t i = 0; i < 9; ++i) pose.m[4 * (i / 3) + i % 3] = near.m[i];
  return true;
}

}  // namespace jalon
