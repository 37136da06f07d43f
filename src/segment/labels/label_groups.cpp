// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/labels/label_groups.h"

#include <limits>

#include "base/error.h"

namespace jalon {

namespace {

constexpr size_t kPointsPerCheckpoint = 1 << 20;

// f(i) for every point, with a look at the task now and then.
template <class F>
void walk(size_t n, Task& task, F&& f) {
  for (size_t begin = 0; begin < n; begin += kPointsPerCheckpoint) {
    task.checkpoint(static_cast<double>(begin) / static_cast<double>(n));
    for (size_t i = begin; i < std::min(n, begin + kPointsPerCheckpoint); ++i) f(i);
  }
}

}  // namespace

LabelGroups::LabelGroups(std::span<const uint32_t> labels, size_t count, Task& task)
    : first_(count + 1, 0) {
  if (labels.size() > std::numeric_limits<uint32_t>::max())
    fail(Status::kLimit, "%zu points; segments can be told apart in at most 4294967295",
         labels.size());
  {
    ProgressSpan span(task, 0, 0.3);
    walk(labels.size(), task, [&](size_t i) {
      if (labels[i] != 0) ++first_[labels[i]];
    });
  }
  for (size_t g = 1; g <= count; ++g) first_[g] += first_[g - 1];
  order_.resize(first_[count]);
  std::vector<uint64_t> next(first_.begin(), first_.end() - 1);
  ProgressSpan span(task, 0.3, 1);
  walk(labels.size(), task, [&](size_t i) {
    if (labels[i] != 0) order_[next[labels[i] - 1]++] = static_cast<uint32_t>(i);
  });
}

}  // namespace jalon
