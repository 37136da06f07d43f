// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/buffer.h"
#include "base/task.h"

namespace jalon {

/// The points of each label 1 ... count, in the order of the cloud.
class LabelGroups {
 public:
  /// labels: 0 = none, else at most count. O(n).
  LabelGroups(std::span<const uint32_t> labels, size_t count, Task& task);
  size_t count() const { return first_.size() - 1; }
  /// Point indices of the label, ascending.
  std::span<const uint32_t> of(uint32_t label) const {
    return {order_.data() + first_[label - 1], first_[label] - first_[label - 1]};
  }
  /// f(label) for every label: large groups one after the other with all threads inside f, small ones side by side.
  template <class F>
  void for_each(Task& task, F&& f) const;

 private:
  std::vector<uint64_t> first_;
  Buffer<uint32_t> order_;
};

}  // namespace jalon

#include "base/parallel.h"

namespace jalon {

template <class F>
void LabelGroups::for_each(Task& task, F&& f) const {
  constexpr size_t kLarge = 1 << 16;  // points: about a millisecond of work
  constexpr size_t kLabelsPerChunk = 16;
  double done = 0;
  for (uint32_t label = 1; label <= count(); ++label) {
    if (of(label).size() < kLarge) continue;
    const double share = static_cast<double>(of(label).size()) / static_cast<double>(order_.size());
    ProgressSpan span(task, done, done + share);
    f(label);
    done += share;
  }
  ProgressSpan span(task, done, 1);
  parallel_for(task, count(), kLabelsPerChunk, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i)
      if (of(static_cast<uint32_t>(i + 1)).size() < kLarge) f(static_cast<uint32_t>(i + 1));
  });
}

}  // namespace jalon
