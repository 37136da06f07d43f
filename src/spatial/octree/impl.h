// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "base/buffer.h"
#include "geometry/vec.h"
#include "spatial/octree/morton.h"
#include "spatial/octree/octree.h"
#include "spatial/octree/view.h"

namespace jalon {

constexpr int kGridBits = 31;  ///< bits of a fixed-point coordinate; the top 21 make the code
constexpr uint32_t kLeafPoints =
    16;  ///< most points of a leaf, and so queries of a group (kMostQueries)
/// Sides of a leaf, in steps, up to which distances on the grid, wrong by up to 2 sqrt(3) steps, do not order its
/// points.
constexpr int64_t kCrowdedSteps = 8;
/// A point on the grid, with the caller's index: what the sort moves.
struct alignas(16) GridPoint {
  int32_t x, y, z;
  uint32_t index;
};

/// Where a point lies on a grid, rounded down; coordinates that are not below the cube's lie on its last step.
inline GridPoint on_grid_of(const double* p, const Vec3& origin, double inverse_step,
                            uint32_t index) {
  constexpr double top = 0x1p31 - 1;
  return {static_cast<int32_t>(std::min((p[0] - origin.x) * inverse_step, top)),
          static_cast<int32_t>(std::min((p[1] - origin.y) * inverse_step, top)),
          static_cast<int32_t>(std::min((p[2] - origin.z) * inverse_step, top)), index};
}

inline uint64_t code_of(int32_t x, int32_t y, int32_t z) {
  constexpr int shift = kGridBits - kMaxLevel;
  return morton_code(static_cast<uint32_t>(x) >> shift, static_cast<uint32_t>(y) >> shift,
                     static_cast<uint32_t>(z) >> shift);
}

constexpr size_t kExactRun = 16;  ///< sorted points that share a box in doubles
/// Closed boxes of eight neighbours in the order of the curve, in the caller's coordinates, and the smallest index of a
/// point in each, kNoPoint in an unused place.
struct ExactBlock {
  double lo[3][kBoxes];
  double hi[3][kBoxes];
  uint32_t least_index[kBoxes];
};

/// Leaves are runs of at most kLeafPoints points inside one octree cell, in curve order. Above them stands a tree
/// without pointers: block b of level i + 1 holds the boxes of blocks 8 b ... 8 b + 7 of level i; the last level is one
/// block.
struct Octree::Impl {
  std::span<const double> xyz;
  Cube cube;
  double step = 1, inverse_step = 1;
  bool on_grid =
      true;  ///< every coordinate equals origin + grid * step: the doubles need not be read
  size_t count = 0;
  Buffer<int32_t> x, y, z;
  Buffer<uint32_t> order;
  /// Points of crowds that were sorted on finer grids, counted on each of them.
  uint64_t sorted_again = 0;
  size_t leaves = 0;
  Buffer<uint32_t> leaf_first;  ///< leaves + 1
  std::vector<Buffer<BoxBlock>> levels;
  /// Such a tree over runs of kExactRun points, in the caller's doubles; empty where the grid tells the points apart.
  std::vector<Buffer<ExactBlock>> exact_levels;
  OctreeView view{};

  bool has_exact_boxes() const { return !exact_levels.empty(); }
  bool share_place(size_t a, size_t b) const {
    return x[a] == x[b] && y[a] == y[b] && z[a] == z[b];
  }
  /// Are there very many points on one place? O(n / 512).
  bool has_pile() const;
  /// The end of the points from first on, before last, that share its place of the grid and follow one another.
  size_t end_of_place(size_t first, size_t last) const;
  /// Do the points of a leaf, not all equal, lie within so few steps of 2^shift of the grid that this hardly tells them
  /// apart?
  bool is_crowded(size_t leaf, int shift) const;
  /// Are there many points in such leaves?
  bool is_crowded_at(int shift, Task& task) const;

  Vec3 grid_point(size_t i) const {
    return {static_cast<double>(x[i]), static_cast<double>(y[i]), static_cast<double>(z[i])};
  }
  /// The caller's coordinates, bit for bit.
  Vec3 exact_point(size_t i) const {
    if (on_grid) {
      return {cube.origin.x + x[i] * step, cube.origin.y + y[i] * step,
              cube.origin.z + z[i] * step};
    }
    const double* p = xyz.data() + 3 * static_cast<size_t>(order[i]);
    return {p[0], p[1], p[2]};
  }
  /// First sorted position with (code >> shift) >= prefix.
  size_t lower_bound(uint64_t prefix, int shift, size_t from, size_t to) const {
    while (from < to) {
      const size_t middle = from + (to - from) / 2;
      if (code_of(x[middle], y[middle], z[middle]) >> shift < prefix) from = middle + 1;
      else to = middle;
    }
    return from;
  }

  /// Sorted positions of the k <= 256 nearest points of a point, itself included, filled up with kNoPoint.
  void nearest_of_point(size_t position, uint32_t k, uint32_t* neighbours) const;

  /// Sorted positions of the k nearest points of a place, nearest first, ties by index; how many there are.
  size_t nearest_of_place(const Vec3& q, size_t k, uint32_t* positions) const;

  /// The sorted position of the point nearest to a place, of equally near ones that of the smallest index; kNoPoint
  /// when none is within the root of squared_reach (m^2).
  uint32_t nearest_position(const Vec3& q, double squared_reach) const;

  void sort_points(Task& task);   ///< fills x, y, z, order, leaf_first (sort.cpp)
  void order_crowds(Task& task);  ///< orders what shares a grid point (crowds.cpp)
  void build_boxes(Task& task);   ///< fills levels (boxes.cpp)
  void build_exact_boxes(
      Task& task);  ///< fills exact_levels where they are needed (exact_boxes.cpp)
};

}  // namespace jalon
