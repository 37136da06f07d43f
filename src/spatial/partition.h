// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstring>
#include <vector>

#include "base/buffer.h"
#include "base/parallel.h"
#include "base/task.h"

namespace jalon {

/// Points a chunk takes: cuts depend on n alone.
inline size_t partition_grain(size_t n) { return std::max<size_t>(size_t{1} << 15, n / 256 + 1); }

/// Fresh memory comes in pages of 2 MiB, when they are first written: the first chunk that scatters over all of them
/// would wait for them all, and a cancel with it. One by one, with looks between.
template <class Record>
void have_pages(Record* fresh, size_t count, Task& task) {
  constexpr size_t kPageRecords = (size_t{2} << 20) / sizeof(Record);
  parallel_for(task, count, kPageRecords, [&](size_t begin, size_t) { fresh[begin] = Record{}; });
}

/// From how many records of each bin each chunk has (chunks rows of bins) to where they begin; returns where each bin
/// begins, and the sum. By stretches of bins, since a column of the table would touch another page in each row.
inline std::vector<size_t> place_chunks(uint32_t* places, size_t chunks, size_t bins, Task& task) {
  constexpr size_t kBinsPerChunk = 1024;
  std::vector<uint32_t> next(bins, 0);
  parallel_for(task, bins, kBinsPerChunk, [&](size_t first, size_t last) {
    for (size_t c = 0; c < chunks; ++c)
      for (size_t b = first; b < last; ++b) next[b] += places[c * bins + b];
  });
  std::vector<size_t> begins(bins + 1);
  uint32_t sum = 0;
  for (size_t b = 0; b < bins; ++b) {
    begins[b] = sum;
    sum += next[b];
    next[b] = static_cast<uint32_t>(begins[b]);
  }
  begins[bins] = sum;
  parallel_for(task, bins, kBinsPerChunk, [&](size_t first, size_t last) {
    for (size_t c = 0; c < chunks; ++c)
      for (size_t b = first; b < last; ++b) {
        const uint32_t count = places[c * bins + b];
        places[c * bins + b] = next[b];
        next[b] += count;
      }
  });
  return begins;
}

/// Stable parallel partition of n < 2^32 records by a digit in [0, bins): read(i) makes record i, which goes to out at
/// its bin. Returns where each bin begins, and n. Two passes: count, then move. A few thousand bins keep the open write
/// streams in the cache.
template <class Record, class Digit, class Read>
std::vector<size_t> partition(size_t n, size_t bins, Digit digit, Task& task, Record* out,
                              Read read) {
  const size_t grain = partition_grain(n), chunks = (n + grain - 1) / grain;
  Buffer<uint32_t> places(chunks * bins);
  {
    ProgressSpan half(task, 0, 0.5);
    parallel_for(task, n, grain, [&](size_t begin, size_t end) {
      uint32_t* counts = places.data() + begin / grain * bins;
      std::memset(counts, 0, bins * sizeof(uint32_t));
      for (size_t i = begin; i < end; ++i) ++counts[digit(read(i))];
    });
  }
  const auto begins = place_chunks(places.data(), chunks, bins, task);
  ProgressSpan half(task, 0.5, 1);
  parallel_for(task, n, grain, [&](size_t begin, size_t end) {
    uint32_t* place = places.data() + begin / grain * bins;
    for (size_t i = begin; i < end; ++i) {
      const Record record = read(i);
      out[place[digit(record)]++] = record;
    }
  });
  return begins;
}

/// Groups of consecutive parts of at least goal items (the last may be smaller): group g holds parts out[g] ... out[g +
/// 1] - 1.
template <class Size>
std::vector<size_t> groups_of(size_t parts, size_t goal, Size size) {
  std::vector<size_t> out{0};
  size_t sum = 0;
  for (size_t p = 0; p < parts; ++p) {
    sum += size(p);
    if (sum < goal && p + 1 < parts) continue;
    out.push_back(p + 1);
    sum = 0;
  }
  return out;
}

}  // namespace jalon
