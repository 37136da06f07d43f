// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/buffer.h"
#include "spatial/neighbours/exact_knn.h"
#include "spatial/neighbours/knn_kernel.h"
#include "spatial/octree/impl.h"

namespace jalon {

/// The k nearest neighbours of points of the tree that lie together, for all at once:
///   1. gather the points in their box widened by a reach, guessed from the group before;
///   2. select the k + 1 nearest candidates of all queries at once, in the vector lanes (knn_kernel.inc);
///   3. a query whose k-th neighbour is not inside the reach: widen it and repeat; far-off queries are answered one by
///   one;
///   4. a query with distances too close to call in single precision on the grid is settled from the caller's doubles.
/// Where the grid does not tell points apart they are answered in doubles (exact_knn.cpp). One a thread; k <= 256.
class KnnGroupSearch {
 public:
  KnnGroupSearch(const Octree& octree, uint32_t k);

  /// Of the points of one leaf: k sorted positions and squared distances (m^2) each, nearest first, ties by index,
  /// filled up with kNoPoint.
  void leaf(size_t leaf, uint32_t* neighbours, float* squared);
  /// Of the points at some sorted positions, kMostQueries at most.
  void group(std::span<const uint32_t> positions, uint32_t* neighbours, float* squared);

 private:
  struct Close {
    double squared;  // on the grid, then exact where it matters
    uint32_t candidate;
  };

  uint32_t all_queries() const { return (1u << group_.count) - 1; }
  void load_queries(size_t count);
  bool same_point(size_t first, size_t count);
  uint32_t answer(uint32_t* neighbours, float* squared);
  int64_t first_reach() const;
  int64_t try_reach(uint32_t pending);
  double truncation() const;
  float squared_of(uint32_t key) const;
  void set_tolerances();
  float squared_metres(size_t a, size_t b) const;
  void write(uint32_t done, uint32_t* neighbours, float* squared);
  void settle(uint32_t q, uint32_t* to, float* to_squared);
  void answer_one(size_t position, uint32_t* to, float* to_squared) const;
  void measure(size_t position, const uint32_t* to, float* to_squared) const;
  void one_by_one(uint32_t pending, uint32_t* neighbours, float* squared);

  const Octree::Impl& tree_;
  const uint32_t k_;
  bool (*const gather_)(const OctreeView&, const GridBox&, Candidates&);
  void (*const search_)(const Candidates&, KnnGroup&);
  ExactKnn exactly_;
  uint32_t positions_[kMostQueries];  // sorted, of the queries
  GridBox box_{};
  int64_t reach_ = 0;                   // grid units; 0 = no guess
  size_t run_begin_ = 0, run_end_ = 0;  // a run of points with the same coordinates
  double largest_ = 0;  // k-th distance of the completed queries of the last attempt
  KnnGroup group_;
  Candidates candidates_;
  Buffer<uint32_t> keys_;
  std::vector<Close> close_;
};

}  // namespace jalon
