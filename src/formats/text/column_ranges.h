// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <limits>
#include <vector>

#include "formats/files/fast_number.h"

namespace jalon {

/// What the cells of one column turned out to be, for its type.
struct ColumnRange {
  bool integers = true, wide = false, beyond_signed = false, beyond_unsigned = false;
  double min = std::numeric_limits<double>::infinity(),
         max = -std::numeric_limits<double>::infinity();
  void add(const ParsedNumber& number) {
    *this += {number.integer,         number.wide,  number.beyond_signed,
              number.beyond_unsigned, number.value, number.value};
  }
  ColumnRange& operator+=(const ColumnRange& b) {
    integers = integers && b.integers;
    wide = wide || b.wide;
    beyond_signed = beyond_signed || b.beyond_signed;
    beyond_unsigned = beyond_unsigned || b.beyond_unsigned;
    min = std::min(min, b.min);
    max = std::max(max, b.max);
    return *this;
  }
};

/// Of each column.
using ColumnRanges = std::vector<ColumnRange>;

inline void add(ColumnRanges& all, const ColumnRanges& part) {
  all.resize(std::max(all.size(), part.size()));
  for (size_t c = 0; c < part.size(); ++c) all[c] += part[c];
}

}  // namespace jalon
