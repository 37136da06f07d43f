// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/parallel.h"
#include "base/task.h"

namespace jalon {

/// What std::nth_element() puts at the place `nth` of at(0) ... at(n - 1), floats of 0 and above, without a list of
/// them: digit by digit, from the most significant one, by counts of the digits (Knuth 1998, 5.2.5). at is asked three
/// times, from any thread.
template <class At>
float nth_value(size_t n, size_t nth, const At& at, Task& task) {
  constexpr uint32_t kDigitBits = 11, kDigits = 1u << kDigitBits;
  constexpr size_t kValuesPerChunk = 1 << 16;
  struct Counts {
    std::vector<uint32_t> of = std::vector<uint32_t>(kDigits, 0);
    Counts& operator+=(const Counts& b) {
      for (size_t d = 0; d < kDigits; ++d) of[d] += b.of[d];
      return *this;
    }
  };
  uint32_t found = 0;   // the digits so far
  uint64_t above = 32;  // bits from here on are known
  for (const uint32_t shift : {21u, 10u, 0u}) {
    const auto mask = static_cast<uint32_t>((uint64_t{1} << above) - 1);
    const Counts counts =
        parallel_reduce(task, n, kValuesPerChunk, Counts{}, [&](size_t begin, size_t end) {
          Counts part;
          for (size_t i = begin; i < end; ++i) {
            const auto bits = std::bit_cast<uint32_t>(at(i));
            if (uint64_t{bits} >> above == uint64_t{found} >> above)
              ++part.of[(bits & mask) >> shift];
          }
          return part;
        });
    uint32_t digit = 0;
    while (nth >= counts.of[digit]) nth -= counts.of[digit++];
    found |= digit << shift;
    above = shift;
  }
  return std::bit_cast<float>(found);
}

}  // namespace jalon
