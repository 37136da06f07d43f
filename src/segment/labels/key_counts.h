// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "base/parallel.h"

namespace jalon {

struct KeyCount {
  uint64_t key = 0, count = 0;
};

/// A key that is not counted.
constexpr uint64_t kNoKey = ~uint64_t{0};

/// Sorts by key and adds up equal ones.
inline void combine(std::vector<KeyCount>& counts) {
  std::sort(counts.begin(), counts.end(),
            [](const KeyCount& a, const KeyCount& b) { return a.key < b.key; });
  size_t kept = 0;
  for (const KeyCount& c : counts) {
    if (kept > 0 && counts[kept - 1].key == c.key) counts[kept - 1].count += c.count;
    else counts[kept++] = c;
  }
  counts.resize(kept);
}

/// How often each key occurs among n items, ascending by key. keys_of(begin, end, keys) writes the keys of a chunk.
/// Neighbouring points mostly have equal keys, so runs are counted before anything is sorted.
template <class F>
std::vector<KeyCount> count_keys(Task& task, size_t n, F&& keys_of) {
  constexpr size_t kChunk = 1 << 15;
  std::vector<std::vector<KeyCount>> parts((n + kChunk - 1) / kChunk);
  parallel_for(task, n, kChunk, [&](size_t begin, size_t end) {
    std::vector<uint64_t> keys(end - begin);
    keys_of(begin, end, keys.data());
    std::vector<KeyCount>& runs = parts[begin / kChunk];
    for (const uint64_t key : keys) {
      if (key == kNoKey) continue;
      if (runs.empty() || runs.back().key != key) runs.push_back({key, 0});
      ++runs.back().count;
    }
    combine(runs);
    runs.shrink_to_fit();
  });
  std::vector<KeyCount> all;
  for (std::vector<KeyCount>& part : parts) {
    all.insert(all.end(), part.begin(), part.end());
    part = {};
  }
  combine(all);
  return all;
}

}  // namespace jalon
