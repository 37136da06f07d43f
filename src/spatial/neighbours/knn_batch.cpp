// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// The k nearest neighbours of every point, leaf by leaf, and of some points, a group of them at a time.

#include "spatial/neighbours/knn_of_some.h"

#include <algorithm>
#include <memory>

#include "base/error.h"
#include "base/parallel.h"
#include "spatial/neighbours/knn_group_search.h"

namespace jalon {

namespace {

// Points that share their candidates: the more, the more of these each looks at in vain. Of every 16th point of the
// street 4 cost 8 % less than 8, and 16 cost 8 % more.
constexpr size_t kSomeTogether = 4;
constexpr size_t kSomeAtOnce = 512;

}  // namespace

void Octree::knn_batches(uint32_t k, Task& task, void (*visit)(void*, const Batch&),
                         void* context) const {
  if (k < 1 || k > 256) fail(Status::kInvalidArgument, "k is %u; 1 ... 256 are possible", k);
  constexpr size_t kLeavesAtOnce = 128;
  parallel_for(task, impl_->leaves, kLeavesAtOnce, [&](size_t begin, size_t end) {
    const size_t first = impl_->leaf_first[begin], count = impl_->leaf_first[end] - first;
    const auto search = std::make_unique<KnnGroupSearch>(*this, k);
    Buffer<uint32_t> neighbours(count * k);
    Buffer<float> squared(count * k);
    for (size_t leaf = begin; leaf < end; ++leaf) {
      if (task.cancelled()) throw Error(Status::kCancelled, "cancelled");
      const size_t at = (impl_->leaf_first[leaf] - first) * k;
      search->leaf(leaf, neighbours.data() + at, squared.data() + at);
    }
    visit(context, {first, count, neighbours.data(), squared.data(), k});
  });
}

void knn_of_some(const Octree& tree, const EveryPoint& points, uint32_t k, Task& task,
                 void (*visit)(void*, const SomeNearest&), void* context) {
  if (k < 1 || k > 256) fail(Status::kInvalidArgument, "k is %u; 1 ... 256 are possible", k);
  parallel_for(task, points.count, kSomeAtOnce, [&](size_t begin, size_t end) {
    const auto search = std::make_unique<KnnGroupSearch>(tree, k);
    Buffer<uint32_t> positions(end - begin), neighbours((end - begin) * k);
    for (size_t i = begin; i < end; ++i)
      positions.data()[i - begin] =
          static_cast<uint32_t>(std::min(points.first + i * points.stride, tree.impl().count - 1));
    Buffer<float> squared(kSomeTogether * k);
    for (size_t from = begin; from < end; from += kSomeTogether) {
      if (task.cancelled()) throw Error(Status::kCancelled, "cancelled");
      const std::span<const uint32_t> group{positions.data() + (from - begin),
                                            std::min(kSomeTogether, end - from)};
      search->group(group, neighbours.data() + (from - begin) * k, squared.data());
    }
    visit(context, {begin, end - begin, positions.data(), neighbours.data()});
  });
}

}  // namespace jalon
