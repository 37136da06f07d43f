// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/labels/label_groups.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "base/error.h"
#include "base/parallel.h"

namespace jalon {

namespace {

// Points of a block. With many labels larger ones, so that all blocks' counts take no more than the points' own labels.
constexpr size_t kBlock = 1 << 18;
size_t block_of(size_t count) { return std::max(kBlock, count); }

}  // namespace

LabelGroups::LabelGroups(std::span<const uint32_t> labels, size_t count, Task& task)
    : first_(count + 1, 0) {
  if (labels.size() > std::numeric_limits<uint32_t>::max())
    fail(Status::kLimit, "%zu points; segments can be told apart in at most 4294967295",
         labels.size());
  // 1. How many points of each label lie in each block.
  const size_t n = labels.size(), block = block_of(count);
  std::vector<uint32_t> next((n + block - 1) / block * count, 0);
  {
    ProgressSpan span(task, 0, 0.3);
    parallel_for(task, n, block, [&](size_t begin, size_t end) {
      uint32_t* counts = next.data() + begin / block * count;
      for (size_t i = begin; i < end; ++i)
        if (labels[i] != 0) ++counts[labels[i] - 1];
    });
  }
  // 2. Where each block puts its first point of each label.
  uint32_t sum = 0;
  for (size_t g = 0; g < count; ++g) {
    for (size_t at = g; at < next.size(); at += count) sum += std::exchange(next[at], sum);
    first_[g + 1] = sum;
  }
  // 3. The points.
  order_ = Buffer<uint32_t>(sum);
  ProgressSpan span(task, 0.3, 1);
  parallel_for(task, n, block, [&](size_t begin, size_t end) {
    uint32_t* to = next.data() + begin / block * count;
    for (size_t i = begin; i < end; ++i)
      if (labels[i] != 0) order_[to[labels[i] - 1]++] = static_cast<uint32_t>(i);
  });
}

}  // namespace jalon
