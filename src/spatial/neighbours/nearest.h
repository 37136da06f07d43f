// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <type_traits>

#include "base/task.h"
#include "spatial/octree/octree.h"

namespace jalon {

/// The nearest points of a run of queries.
struct NearestBatch {
  size_t first, count;  ///< sorted positions [first, first + count) of the queries' tree
  const uint32_t*
      nearest;  ///< sorted positions in the reference; kNoPoint: none within the greatest distance
  const double* squared;  ///< m^2 between the caller's coordinates; infinity where there is none
};

/// For every point of compared its nearest point of reference, of equally near ones that of the smallest index: what
/// brute force over the caller's doubles gives, whatever the cubes of the two trees, the threads and the instruction
/// set. Points farther than max_distance_m (infinity: no limit) count as none and cost little. visit(NearestBatch),
/// chunks of consecutive positions, in parallel.
template <class F>
void for_each_nearest(const Octree& reference, const Octree& compared, double max_distance_m,
                      Task& task, F&& visit) {
  using Visit = std::remove_reference_t<F>;
  const auto call = [](void* p, const NearestBatch& b) { (*static_cast<Visit*>(p))(b); };
  nearest_batches(reference, compared, max_distance_m, task, call, &visit);
}
void nearest_batches(const Octree& reference, const Octree& compared, double max_distance_m,
                     Task& task, void (*visit)(void*, const NearestBatch&), void* context);

}  // namespace jalon
