// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Single queries for the k nearest points: in the vector lanes where the grid can order them, which it nearly always
// can, else in doubles. Few of the caller's coordinates are read, which lie anywhere in memory.

#include "spatial/neighbours/nearest_by_grid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "base/simd.h"
#include "spatial/neighbours/knn_kernel.h"

namespace jalon {

namespace {

bool place_on_grid(const Octree::Impl& tree, const Vec3& q, int32_t (&out)[3]) {
  const Vec3 at = (q - tree.cube.origin) * tree.inverse_step;
  for (int axis = 0; axis < 3; ++axis) {
    if (!(at[axis] >= 0 && at[axis] < 0x1p31)) return false;
    out[axis] = static_cast<int32_t>(at[axis]);
  }
  return true;
}

// The k nearest of a place; take(j, position, squared distance).
template <class Take>
size_t for_each_of_nearest(const Octree::Impl& tree, const Vec3& q, uint32_t k, Take take) {
  std::array<uint32_t, kMostByGrid> few;
  std::vector<uint32_t> many(k > kMostByGrid ? std::min<size_t>(k, tree.count) : 0);
  uint32_t* positions = k > kMostByGrid ? many.data() : few.data();
  int32_t query[3];
  const bool by_grid = k > 0 && k <= kMostByGrid && k < tree.count && !tree.has_exact_boxes() &&
                       place_on_grid(tree, q, query) &&
                       nearest_by_grid(tree, query, false, k, positions);
  const size_t found = by_grid ? k : tree.nearest_of_place(q, k, positions);
  for (size_t j = 0; j < found; ++j)
    take(j, positions[j], squared_norm(tree.exact_point(positions[j]) - q));
  return found;
}

}  // namespace

bool nearest_by_grid(const Octree::Impl& tree, const int32_t (&query)[3], bool is_exact, uint32_t k,
                     uint32_t* to) {
  static_assert(kMostByGrid < kMostOnGrid);
  float squared[kMostByGrid + 1];
  uint32_t found[kMostByGrid + 1];
  const auto nearest = use_avx2() ? nearest_on_grid_avx2 : nearest_on_grid_baseline;
  nearest(tree.view, query, k + 1, squared, found);
  // |d_j - d_i| <= 2 sqrt(3) means |d_j^2 - d_i^2| <= 2 sqrt(3) (2 d_k + 2 sqrt(3)).
  const float floor = is_exact ? 0 : 7 * std::sqrt(squared[k - 1]) + 13;
  for (uint32_t j = 0; j < k; ++j)
    if (!(squared[j + 1] - squared[j] > squared[j + 1] * 0x1p-20f + floor)) return false;
  std::copy_n(found, k, to);
  return true;
}

size_t Octree::knn(const Vec3& q, uint32_t k, std::span<Neighbour> out) const {
  return for_each_of_nearest(*impl_, q, k, [&](size_t j, uint32_t position, double squared) {
    out[j] = {squared, impl_->order[position]};
  });
}

size_t Octree::knn_positions(const Vec3& q, uint32_t k, std::span<Neighbour> out) const {
  return for_each_of_nearest(*impl_, q, k, [&](size_t j, uint32_t position, double squared) {
    out[j] = {squared, position};
  });
}

}  // namespace jalon
