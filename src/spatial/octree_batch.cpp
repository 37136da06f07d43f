// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// All-points queries, chunk by chunk in sorted order.

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.h"
#include "base/parallel.h"
#include "spatial/octree_impl.h"

namespace jalon {

namespace {

std::vector<uint32_t> positions_of(const Octree::Impl& tree) {
  std::vector<uint32_t> position(tree.count);
  for (size_t i = 0; i < tree.count; ++i) position[tree.order[i]] = static_cast<uint32_t>(i);
  return position;
}

}  // namespace

void Octree::ball_batches(double radius_m, Task& task, void (*visit)(void*, const BallBatch&), void* context) const {
  if (!(radius_m >= 0)) fail(Status::kInvalidArgument, "the radius is negative");
  const auto position = positions_of(*impl_);
  parallel_for(task, size(), 512, [&](size_t begin, size_t end) {
    std::vector<uint32_t> offsets{0}, neighbours;
    std::vector<float> squared;
    std::vector<Neighbour> found;
    size_t first = begin;
    constexpr size_t kMostNeighbours = size_t{1} << 21;
    for (size_t i = begin; i < end; ++i) {
      radius(impl_->exact_point(i), radius_m, found);
      for (const Neighbour& n : found) {
        neighbours.push_back(position[n.index]);
        squared.push_back(static_cast<float>(n.squared_distance));
      }
      offsets.push_back(static_cast<uint32_t>(neighbours.size()));
      if (neighbours.size() < kMostNeighbours && i + 1 < end) continue;
      visit(context, {first, i + 1 - first, offsets.data(), neighbours.data(), squared.data()});
      first = i + 1;
      offsets.assign(1, 0);
      neighbours.clear();
      squared.clear();
    }
  });
}

}  // namespace jalon
