// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/labels/whole_numbers.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/error.h"
#include "segment/labels/key_counts.h"

namespace jalon {

namespace {

bool is_whole(double value) {
  return std::fabs(value) <= kWholeDoubles && value == std::trunc(value);
}

}  // namespace

WholeNumbers::WholeNumbers(const Column& column, std::span<const double> left_out)
    : column_(column) {
  const FieldInfo& info = column.info();
  if (info.components != 1)
    fail(Status::kInvalidArgument,
         "field \"%.100s\" has %u components; one number a point is needed", info.name.c_str(),
         info.components);
  for (const double value : left_out) {
    if (!is_whole(value))
      fail(Status::kInvalidArgument, "the values to leave out must be whole numbers");
    left_out_.push_back(key_of(static_cast<int64_t>(value)));
  }
}

void WholeNumbers::keys(size_t begin, size_t end, uint64_t* out) const {
  visit(column_.info().type, [&](auto zero) {
    const auto values = column_.values<decltype(zero)>();
    for (size_t i = begin; i < end; ++i) out[i - begin] = key(values[i], i);
  });
}

template <class T>
uint64_t WholeNumbers::key(T value, size_t i) const {
  if constexpr (std::is_floating_point_v<T>) {
    if (std::isnan(value)) return kNoKey;
    if (!is_whole(static_cast<double>(value))) refuse(i, "no whole number");
  } else if constexpr (sizeof(T) == 8) {
    if (std::cmp_greater_equal(value, std::numeric_limits<int64_t>::max()))
      refuse(i, "too large a number");
  }
  const uint64_t found = key_of(static_cast<int64_t>(value));
  return std::find(left_out_.begin(), left_out_.end(), found) == left_out_.end() ? found : kNoKey;
}

void WholeNumbers::refuse(size_t i, const char* why) const {
  fail(Status::kInvalidArgument, "field \"%.100s\" of point %zu is %s", column_.info().name.c_str(),
       i, why);
}

}  // namespace jalon
