// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// A crowd: more points than a leaf's on one grid point, not all of them equal. The grid cannot order them, and leaves
// in the order of their indices would all have to be looked at for each question about one of them. So a crowd is
// sorted on a grid of its own box, and so are the crowds in that. Each grid is 2^30 times as fine as the one above, or
// finer, and cubes of octrees end at 2^60 m, doubles at 2^-1074: there are less than 40.

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/parallel.h"
#include "spatial/octree/impl.h"
#include "spatial/partition.h"

namespace jalon {

namespace {

// Points that are worth a hand-over; larger crowds are sorted by all threads, one after the other.
constexpr size_t kCrowdTask = size_t{1} << 15;

constexpr size_t kPile = 512;  // points on a place: their pairs alone are 2^18

// Consecutive sorted positions.
struct Run {
  size_t first, count;
};

// Grid points with more points than a leaf's; they begin with a leaf (cut_leaves).
std::vector<Run> full_grid_points(const Octree::Impl& tree, Task& task) {
  constexpr size_t kGrain = size_t{1} << 13;  // leaves
  std::vector<std::vector<Run>> parts((tree.leaves + kGrain - 1) / kGrain);
  parallel_for(task, tree.leaves, kGrain, [&](size_t begin, size_t end) {
    for (size_t leaf = begin; leaf < end; ++leaf) {
      const size_t first = tree.leaf_first[leaf];
      if (first + kLeafPoints >= tree.count || !tree.share_place(first, first + kLeafPoints) ||
          (leaf > 0 && tree.share_place(tree.leaf_first[leaf - 1], first)))
        continue;
      parts[begin / kGrain].push_back({first, tree.end_of_place(first, tree.count) - first});
    }
  });
  std::vector<Run> out;
  for (const auto& part : parts) out.insert(out.end(), part.begin(), part.end());
  return out;
}

class Crowds {
 public:
  Crowds(Octree::Impl& tree, Task& task) : tree_(tree), task_(task) {}

  /// Sorts a crowd; equal points stay as they are, by index.
  void order(const Run& run) {
    for (const Run& full : order_on_own_grid(run)) order({run.first + full.first, full.count});
  }

 private:
  Vec3 at(size_t position) const {
    const double* p = tree_.xyz.data() + 3 * size_t{tree_.order[position]};
    return {p[0], p[1], p[2]};
  }

  Box3 box_of(const Run& run) const {
    return parallel_reduce(task_, run.count, partition_grain(run.count), Box3{},
                           [&](size_t begin, size_t end) {
                             Box3 box;
                             for (size_t i = begin; i < end; ++i) box.add(at(run.first + i));
                             return box;
                           });
  }

  // The points' coordinates in the box of the run, whose longest side lies between a half and 1.
  Buffer<double> scaled(const Run& run, const Box3& box, double longest) const {
    Buffer<double> out(3 * run.count);
    const int exponent = std::ilogb(longest) + 1;
    parallel_for(task_, run.count, partition_grain(run.count), [&](size_t begin, size_t end) {
      for (size_t i = begin; i < end; ++i) {
        const Vec3 p = at(run.first + i) - box.min;
        for (int axis = 0; axis < 3; ++axis)
          out[3 * i + static_cast<size_t>(axis)] = std::ldexp(p[axis], -exponent);
      }
    });
    return out;
  }

  // Returns the grid points that are full again, from the first of the run on.
  std::vector<Run> order_on_own_grid(const Run& run) {
    const Box3 box = box_of(run);
    const Vec3 extent = box.max - box.min;
    const double longest = std::max({extent.x, extent.y, extent.z});
    if (!(longest > 0)) return {};
    const Buffer<double> xyz = scaled(run, box, longest);
    Octree::Impl own;
    own.xyz = {xyz.data(), xyz.size()};
    own.step = std::ldexp(own.cube.edge, -kGridBits);
    own.inverse_step = 1 / own.step;
    own.count = run.count;
    own.sort_points(task_);
    uint32_t* order = tree_.order.data() + run.first;
    for (size_t i = 0; i < run.count; ++i) own.order[i] = order[own.order[i]];
    std::copy_n(own.order.data(), run.count, order);
    return full_grid_points(own, task_);
  }

  Octree::Impl& tree_;
  Task& task_;
};

}  // namespace

size_t Octree::Impl::end_of_place(size_t first, size_t last) const {
  size_t inside = first;
  while (inside + 1 < last && inside < first + kLeafPoints && share_place(first, inside + 1))
    ++inside;
  if (inside < first + kLeafPoints) return inside + 1;
  // More points than a leaf's on one place stand together: they end between two probes.
  size_t stride = kLeafPoints;
  while (inside + stride < last && share_place(first, inside + stride)) {
    inside += stride;
    stride *= 2;
  }
  size_t outside = std::min(last, inside + stride);
  while (outside - inside > 1) {
    const size_t middle = inside + (outside - inside) / 2;
    (share_place(first, middle) ? inside : outside) = middle;
  }
  return outside;
}

size_t Octree::end_of_place(size_t first) const { return impl_->end_of_place(first, size()); }

bool Octree::has_crowds() const { return impl_->has_exact_boxes(); }

bool Octree::Impl::has_pile() const {
  for (size_t i = kPile; i < count; i += kPile)
    if (share_place(i - kPile, i)) return true;
  return false;
}

void Octree::Impl::order_crowds(Task& task) {
  if (on_grid) return;  // what shares a grid point is equal
  const std::vector<Run> runs = full_grid_points(*this, task);
  if (runs.empty()) return;
  Crowds crowds(*this, task);
  for (const Run& run : runs)
    if (run.count > kCrowdTask) crowds.order(run);
  const auto groups = groups_of(runs.size(), kCrowdTask, [&](size_t r) { return runs[r].count; });
  parallel_chunks(task, groups.size() - 1, [&](size_t g) {
    for (size_t r = groups[g]; r < groups[g + 1]; ++r)
      if (runs[r].count <= kCrowdTask) crowds.order(runs[r]);
  });
}

}  // namespace jalon
