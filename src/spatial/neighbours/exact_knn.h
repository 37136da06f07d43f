// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "spatial/octree/impl.h"

namespace jalon {

/// The k nearest neighbours of the points of leaves whose points the grid does not tell apart, in doubles: as the
/// search on the grid, the candidates of a leaf are gathered once, within a reach guessed from the leaf before, and a
/// point that needs more is answered by itself. For a tree that has boxes in doubles; one a thread.
class ExactKnn {
 public:
  ExactKnn(const Octree::Impl& tree, uint32_t k);

  /// Sorted positions of the neighbours of the points of a leaf, k each, nearest first, ties by index; filled up with
  /// kNoPoint.
  void leaf(size_t leaf, uint32_t* neighbours);
  /// The same for one point.
  void point(size_t position, uint32_t* neighbours) const;

 private:
  struct Near {
    double squared;
    uint32_t index, position;
    bool operator<(const Near& b) const {
      return squared < b.squared || (squared == b.squared && index < b.index);
    }
  };
  bool gather(const Box3& box);
  void select(const Vec3& query);
  bool is_certain(const Vec3& query, const Box3& box) const;

  const Octree::Impl& tree_;
  const size_t k_;
  double reach_m_ = 0;               // 0: no guess
  std::vector<double> x_, y_, z_;    // of the candidates
  std::vector<uint32_t> positions_;  // theirs
  std::vector<double> squared_;      // their distances from the query
  std::vector<Near> nearest_;        // of the query, nearest first
};

}  // namespace jalon
