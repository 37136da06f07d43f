// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "base/task.h"
#include "cloud/cloud.h"

namespace jalon {

/// Items of one type that come one after another: memory grows by blocks with what has come, for no
/// count in a file is believed.
class GrowingColumn {
 public:
  /// before: items that stand in front without a value: 0 of integers, NaN of floats.
  GrowingColumn(FieldInfo info, size_t before);
  /// Rounded to the nearest of an integer type, at its limits beyond them; NaN becomes 0 there.
  void add(double value);
  void add_none();
  /// So many items behind the last, to be put.
  void extend(size_t count);
  /// From item `first` on, as add() does. Any thread, of items of its own.
  void put(size_t first, std::span<const double> values);
  size_t size() const { return size_; }
  const FieldInfo& info() const { return info_; }
  /// Moves all to `out`, which has room for them, and frees each block behind it.
  void move_to(void* out, Task& task);

 private:
  void* room();
  static constexpr size_t kBlockItems = size_t{1} << 15;
  FieldInfo info_;
  size_t size_ = 0;
  std::vector<std::unique_ptr<std::byte[]>> blocks_;
};

/// A cloud whose number of points is known when the last has come: points, scalar fields that may
/// join later, stations.
class GrowingCloud {
 public:
  GrowingCloud();
  /// The number of the field of this name, which is made where there is none yet; earlier points
  /// have no value of it.
  size_t field(const FieldInfo& info);
  /// The points from now on belong to it.
  void begin_station(const std::string& name, const Transform* pose);
  /// values: of the fields in `numbers`; the point has none of the others.
  void add(const Vec3& point, std::span<const size_t> numbers, std::span<const double> values);
  /// So many points behind the last, to be put, with the fields in `numbers`; none of the others.
  /// The number of the first.
  size_t extend(size_t count, std::span<const size_t> numbers);
  /// Points, or their values of a field, from point `first` on. Any thread, of points of its own.
  void put(size_t first, std::span<const double> xyz) { x_.put(3 * first, xyz); }
  void put_field(size_t number, size_t first, std::span<const double> values) {
    fields_[number].put(first, values);
  }
  size_t size() const { return x_.size() / 3; }
  Cloud finish(Task& task);

 private:
  GrowingColumn x_;  ///< x, y, z one after another
  std::vector<GrowingColumn> fields_;
  std::vector<Station> stations_;
};

/// The rotation nearest to the 3 x 3 part of a pose that a file tells with few digits, by its
/// quaternion; false where that part is none even within `tolerance`, or holds what is not finite.
bool make_rigid(Transform& pose, double tolerance);

}  // namespace jalon
