// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "cloud/cloud.h"
#include "formats/e57/records.h"

namespace jalon::e57 {

/// A column of the records that becomes a field.
struct FieldColumn {
  size_t column = 0;
  FieldInfo field;
  double factor = 1, shift = 0;
  std::optional<size_t> invalid;  ///< the column that says where it has no value
};

/// Where the columns of a scan's records go.
struct ScanLayout {
  size_t position[3] = {};  ///< x y z, or range azimuth elevation
  bool spherical = false;
  std::optional<size_t> invalid;
  std::vector<FieldColumn> fields;
};

/// Some records of a scan, next to each other, as points: of those that the scan says are valid.
class RecordPoints {
 public:
  RecordPoints(const Records& records, const ScanLayout& layout, size_t begin, size_t end);
  size_t count() const { return layout_.invalid ? valid_.size() : end_ - begin_; }
  /// x y z of each.
  std::vector<double> places(const std::optional<Transform>& pose) const;
  std::vector<double> values(const FieldColumn& field) const;

 private:
  std::vector<double> column(size_t number) const;
  size_t record(size_t point) const { return layout_.invalid ? valid_[point] : point; }

  const Records& records_;
  const ScanLayout& layout_;
  const size_t begin_, end_;
  std::vector<size_t> valid_;  ///< where the scan says which are
};

}  // namespace jalon::e57
