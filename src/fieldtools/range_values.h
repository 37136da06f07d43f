// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

namespace jalon {

/// What values make of ranges of their positions, by a tree over them: sums, least or greatest. join is associative but
/// for rounding; the order of its operands depends on the range only. A range costs O(log n).
template <class Join>
class RangeValues {
 public:
  RangeValues(std::span<const double> values, Join join) : values_(values), join_(join) {
    for (std::span<const double> below = values_; below.size() > kFan; below = levels_.back()) {
      std::vector<double> level((below.size() + kFan - 1) / kFan);
      for (size_t i = 0; i < level.size(); ++i) {
        level[i] = below[i * kFan];
        for (size_t j = i * kFan + 1; j < std::min(below.size(), (i + 1) * kFan); ++j)
          level[i] = join_(level[i], below[j]);
      }
      levels_.push_back(std::move(level));
    }
  }

  /// join of start and the values [first, last).
  double over(size_t first, size_t last, double start) const {
    std::span<const double> row = values_;
    for (size_t level = 0;; ++level) {
      const bool is_top = level == levels_.size();
      // What is not a whole group on either side; the groups between go up.
      const size_t whole = is_top ? last : std::min(last, (first + kFan - 1) / kFan * kFan);
      for (; first < whole; ++first) start = join_(start, row[first]);
      if (is_top || first == last) return start;
      const size_t rest = std::max(first, last / kFan * kFan);
      for (size_t i = rest; i < last; ++i) start = join_(start, row[i]);
      first /= kFan;
      last = rest / kFan;
      row = levels_[level];
    }
  }

 private:
  static constexpr size_t kFan = 16;
  std::span<const double> values_;
  Join join_;
  std::vector<std::vector<double>> levels_;
};

}  // namespace jalon
