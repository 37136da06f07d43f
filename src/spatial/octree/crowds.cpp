// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// A crowd: more points than a leaf's on one grid point, not all of them equal. The grid cannot order them, and leaves
// in the order of their indices would all have to be looked at for each question about one of them. So a crowd is
// sorted on a grid of its own box, and so are the crowds in that. Each grid is 2^30 times as fine as the one above, or
// finer, and cubes of octrees end at 2^60 m, doubles at 2^-1074: there are less than 40. Where most points of a crowd
// share one place of its grid again, only the others are sorted there: a line whose spacing shrinks all the way would
// else be sorted as a whole on each grid.

#include <algorithm>
#include <atomic>
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

// Points of a crowd, by their numbers in it. Those of a place that most of them share stand in order already.
struct Parting {
  std::vector<uint32_t>
      sorted;  // that are sorted: all elsewhere, and more of the place than a leaf's
  std::vector<uint32_t> rest;  // of the place, behind the last of those; empty: all are sorted
  uint32_t last = 0;           // of the place, of those that are sorted
};

bool on_one_place(const GridPoint& a, const GridPoint& b) {
  return a.x == b.x && a.y == b.y && a.z == b.z;
}

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

  uint64_t sorted() const { return sorted_; }
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
    const int exponent = -(std::ilogb(longest) + 1);
    // By halves: the whole may be no number.
    const double first = std::ldexp(1.0, exponent / 2),
                 second = std::ldexp(1.0, exponent - exponent / 2);
    parallel_for(task_, run.count, partition_grain(run.count), [&](size_t begin, size_t end) {
      for (size_t i = begin; i < end; ++i) {
        const Vec3 p = at(run.first + i) - box.min;
        for (int axis = 0; axis < 3; ++axis)
          out[3 * i + static_cast<size_t>(axis)] = p[axis] * first * second;
      }
    });
    return out;
  }

  static GridPoint place_of(const Buffer<double>& xyz, size_t i) {
    return on_grid_of(xyz.data() + 3 * i, {}, std::ldexp(1.0, kGridBits), static_cast<uint32_t>(i));
  }

  // The place that most points share, if any does: that which some of them vote for (Boyer & Moore 1991).
  static GridPoint likely_place(const Buffer<double>& xyz, size_t count) {
    constexpr size_t kVoters = 64;
    GridPoint leading{};
    int lead = 0;
    for (size_t voter = 0; voter < kVoters; ++voter) {
      const GridPoint place = place_of(xyz, voter * count / kVoters);
      if (lead == 0) leading = place;
      lead += on_one_place(place, leading) ? 1 : -1;
    }
    return leading;
  }

  Parting parted(const Buffer<double>& xyz, size_t count) const {
    constexpr size_t kHalf = 2;  // fewer than one in so many there: all are sorted
    const GridPoint place = likely_place(xyz, count);
    std::vector<uint8_t> is_there(count);
    parallel_for(task_, count, partition_grain(count), [&](size_t begin, size_t end) {
      for (size_t i = begin; i < end; ++i) is_there[i] = on_one_place(place_of(xyz, i), place);
    });
    Parting out;
    size_t there = 0;
    for (const uint8_t is : is_there) there += is;
    if (there < count / kHalf || there <= kLeafPoints + 1) return out;
    size_t seen = 0;
    for (size_t i = 0; i < count; ++i) {
      // So many that their cell is no single leaf, in which points would stand by index.
      const bool is_rest = is_there[i] != 0 && seen++ > kLeafPoints;
      (is_rest ? out.rest : out.sorted).push_back(static_cast<uint32_t>(i));
      if (is_there[i] != 0 && !is_rest) out.last = static_cast<uint32_t>(i);
    }
    return out;
  }

  // Returns the grid points that are full again, from the first of the run on.
  std::vector<Run> order_on_own_grid(const Run& run) {
    const Box3 box = box_of(run);
    const Vec3 extent = box.max - box.min;
    const double longest = std::max({extent.x, extent.y, extent.z});
    if (!(longest > 0)) return {};
    Buffer<double> xyz = scaled(run, box, longest);
    const Parting parting = parted(xyz, run.count);
    if (!parting.rest.empty()) {
      for (size_t k = 0; k < parting.sorted.size(); ++k)
        std::copy_n(xyz.data() + 3 * size_t{parting.sorted[k]}, 3, xyz.data() + 3 * k);
    }
    Octree::Impl own;
    own.count = parting.rest.empty() ? run.count : parting.sorted.size();
    own.xyz = {xyz.data(), 3 * own.count};
    own.step = std::ldexp(own.cube.edge, -kGridBits);
    own.inverse_step = 1 / own.step;
    own.sort_points(task_);
    sorted_ += own.count;
    return put_back(run, parting, own);
  }

  // The crowd in the order of its grid; the grid points that are full again.
  std::vector<Run> put_back(const Run& run, const Parting& parting, const Octree::Impl& own) {
    const uint32_t* order = tree_.order.data() + run.first;
    std::vector<uint32_t> ordered;
    ordered.reserve(run.count);
    size_t behind = own.count;  // where the rest was put in
    for (size_t i = 0; i < own.count; ++i) {
      const uint32_t from = parting.rest.empty() ? own.order[i] : parting.sorted[own.order[i]];
      ordered.push_back(order[from]);
      if (parting.rest.empty() || from != parting.last) continue;
      behind = i + 1;
      for (const uint32_t r : parting.rest) ordered.push_back(order[r]);
    }
    std::copy(ordered.begin(), ordered.end(), tree_.order.data() + run.first);
    std::vector<Run> full = full_grid_points(own, task_);
    for (Run& place : full) {
      if (place.first >= behind) place.first += parting.rest.size();
      else if (place.first + place.count == behind) place.count += parting.rest.size();
    }
    return full;
  }

  Octree::Impl& tree_;
  Task& task_;
  std::atomic<uint64_t> sorted_{0};
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
  sorted_again = crowds.sorted();
}

}  // namespace jalon
