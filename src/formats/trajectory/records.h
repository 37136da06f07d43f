// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "base/task.h"
#include "base/text_number.h"
#include "formats/files/byte_source.h"
#include "formats/files/endian.h"

namespace jalon {

/// take(record, doubles) for each record of N little-endian doubles of a file that has nothing else.
/// Error(kFormat) where the file ends within a record, or a number of those named is not finite.
template <size_t N, class F>
void for_each_record(const ByteSource& source, const std::array<const char*, N>& names, Task& task,
                     F&& take) {
  constexpr size_t kBytes = 8 * N, kTogether = 4096;  // records read at a time: half a megabyte
  const uint64_t records = source.size() / kBytes;
  if (source.size() % kBytes != 0)
    source.refuse(records * kBytes, "record %llu is cut off: %llu of its %zu bytes are there",
                  static_cast<unsigned long long>(records),
                  static_cast<unsigned long long>(source.size() % kBytes), kBytes);
  std::vector<std::byte> block(kTogether * kBytes);
  std::array<double, N> values;
  for (uint64_t first = 0; first < records; first += kTogether) {
    task.checkpoint(static_cast<double>(first) / static_cast<double>(records));
    const size_t count = static_cast<size_t>(std::min<uint64_t>(kTogether, records - first));
    source.read(first * kBytes, block.data(), count * kBytes);
    for (size_t i = 0; i < count; ++i) {
      for (size_t k = 0; k < N; ++k) {
        values[k] = load<double>(block.data() + i * kBytes + 8 * k);
        if (names[k] != nullptr && !std::isfinite(values[k]))
          source.refuse((first + i) * kBytes + 8 * k, "record %llu: %s is %s",
                        static_cast<unsigned long long>(first + i), names[k],
                        text_of(values[k]).c_str());
      }
      take(first + i, values);
    }
  }
}

}  // namespace jalon
