// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "spatial/neighbours/exact_knn.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "spatial/octree/exact_walk.h"

namespace jalon {

namespace {

constexpr size_t kMostExactCandidates = 1024;  // more: the points are answered one by one
// The reach guessed for a leaf: what the leaf before needed, and a fifth more, as on the grid.
constexpr double kExactGuess = 1.2;
// But this part of the leaf's longest side at least: of piles it would be nothing.
constexpr double kLeastGuess = 0.125;

bool overlap(const ExactBlock& block, size_t slot, const Box3& box) {
  for (int axis = 0; axis < 3; ++axis)
    if (block.lo[axis][slot] > box.max[axis] || block.hi[axis][slot] < box.min[axis]) return false;
  return true;
}

Box3 box_of_leaf(const Octree::Impl& tree, size_t leaf) {
  Box3 box;
  for (size_t i = tree.leaf_first[leaf]; i < tree.leaf_first[leaf + 1]; ++i)
    box.add(tree.exact_point(i));
  return box;
}

Box3 widened(const Box3& box, double by_m) {
  const Vec3 margin{by_m, by_m, by_m};
  return {box.min - margin, box.max + margin};
}

}  // namespace

ExactKnn::ExactKnn(const Octree::Impl& tree, uint32_t k)
    : tree_(tree), k_(k), squared_(kMostExactCandidates) {}

void ExactKnn::point(size_t position, uint32_t* neighbours) const {
  tree_.nearest_of_point(position, static_cast<uint32_t>(k_), neighbours);
}

void ExactKnn::leaf(size_t leaf, uint32_t* neighbours) {
  const Box3 own = box_of_leaf(tree_, leaf), box = widened(own, reach_m_);
  const bool gathered = reach_m_ > 0 && gather(box);
  double largest = 0;
  for (size_t i = tree_.leaf_first[leaf]; i < tree_.leaf_first[leaf + 1]; ++i, neighbours += k_) {
    const Vec3 query = tree_.exact_point(i);
    if (gathered) select(query);
    if (gathered && is_certain(query, box)) {
      for (size_t j = 0; j < k_; ++j) neighbours[j] = nearest_[j].position;
    } else {
      point(i, neighbours);
    }
    const uint32_t last = neighbours[k_ - 1];
    if (last != kNoPoint)
      largest = std::max(largest, squared_norm(tree_.exact_point(last) - query));
  }
  const Vec3 side = own.max - own.min;
  reach_m_ =
      std::max(kExactGuess * std::sqrt(largest), kLeastGuess * std::max({side.x, side.y, side.z}));
}

// The points of the box; false when there are too many.
bool ExactKnn::gather(const Box3& box) {
  x_.clear();
  y_.clear();
  z_.clear();
  positions_.clear();
  exact_runs(
      tree_,
      [&](const ExactBlock& block, size_t slot) {
        return positions_.size() <= kMostExactCandidates && overlap(block, slot, box);
      },
      [&](size_t first, size_t last) {
        for (size_t i = first; i < last; ++i) {
          const Vec3 p = tree_.exact_point(i);
          if (!box.contains(p)) continue;
          x_.push_back(p.x);
          y_.push_back(p.y);
          z_.push_back(p.z);
          positions_.push_back(static_cast<uint32_t>(i));
        }
      });
  return positions_.size() <= kMostExactCandidates;
}

// The k nearest candidates, in squared distances rounded as everywhere.
void ExactKnn::select(const Vec3& query) {
  const size_t count = positions_.size();
  for (size_t c = 0; c < count; ++c) {
    const double dx = x_[c] - query.x, dy = y_[c] - query.y, dz = z_[c] - query.z;
    squared_[c] = dx * dx + dy * dy + dz * dz;
  }
  nearest_.clear();
  double worst = std::numeric_limits<double>::infinity();
  for (size_t c = 0; c < count; ++c) {
    if (squared_[c] > worst) continue;
    const Near candidate{squared_[c], tree_.order[positions_[c]], positions_[c]};
    if (nearest_.size() == k_) {
      if (!(candidate < nearest_[0])) continue;
      std::pop_heap(nearest_.begin(), nearest_.end());
      nearest_.back() = candidate;
    } else {
      nearest_.push_back(candidate);
    }
    std::push_heap(nearest_.begin(), nearest_.end());
    if (nearest_.size() == k_) worst = nearest_[0].squared;
  }
  std::sort_heap(nearest_.begin(), nearest_.end());
}

// Is a point beyond the box surely farther than all that were selected?
bool ExactKnn::is_certain(const Vec3& query, const Box3& box) const {
  if (nearest_.size() < k_) return false;
  double least = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis)
    least = std::min({least, query[axis] - box.min[axis], box.max[axis] - query[axis]});
  return nearest_.back().squared < least * least;
}

}  // namespace jalon
