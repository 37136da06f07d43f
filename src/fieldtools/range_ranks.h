// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/task.h"

namespace jalon {

/// The k-th least of the values at ranges of positions, without looking at them: a wavelet matrix over their ranks
/// (Claude, Navarro & Ordonez 2015). About 3 B a value; a question costs O(ranges log n).
class RangeRanks {
 public:
  struct Range {
    uint32_t first, last;  ///< [first, last)
  };

  RangeRanks(std::span<const double> values, Task& task);

  /// The k-th least, from 0, of the values in the ranges, which hold more than k; the ranges are used up.
  double least(std::vector<Range>& ranges, size_t k) const;

 private:
  // Bit b of the ranks, in the order in which the bits above have sorted them.
  struct Level {
    std::vector<uint64_t> ones;
    std::vector<uint32_t> before;  // ones before each word
    uint32_t zeros = 0;
    uint32_t ones_before(uint32_t i) const;
  };
  std::vector<Level> levels_;  // highest bit first
  std::vector<double> sorted_;
};

}  // namespace jalon
