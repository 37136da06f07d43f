// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <type_traits>

#include "base/task.h"
#include "spatial/octree/octree.h"

namespace jalon {

/// Every stride-th point in the tree's order, from sorted position `first` on; in the place of those behind the end
/// stands the last one.
struct EveryPoint {
  size_t first, stride, count;
};

/// Consecutive ones of them: the points number ... number + count - 1, each with k neighbours.
struct SomeNearest {
  size_t number, count;
  const uint32_t* positions;  ///< sorted, of the points
  const uint32_t*
      neighbours;  ///< count * k sorted positions, nearest first, ties by index; kNoPoint fills up
};

void knn_of_some(const Octree& tree, const EveryPoint& points, uint32_t k, Task& task,
                 void (*visit)(void*, const SomeNearest&), void* context);

/// The k nearest (itself included; k <= 256) of every stride-th point: visit(SomeNearest), in parallel. What
/// Octree::knn says of each of them, some four times as fast where the points are dense: those that follow one another
/// in the tree's order share their candidates.
template <class F>
void for_each_nearest_of_some(const Octree& tree, const EveryPoint& points, uint32_t k, Task& task,
                              F&& visit) {
  knn_of_some(
      tree, points, k, task,
      [](void* p, const SomeNearest& b) { (*static_cast<std::remove_reference_t<F>*>(p))(b); },
      &visit);
}

}  // namespace jalon
