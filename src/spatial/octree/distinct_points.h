// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "base/buffer.h"
#include "base/task.h"
#include "spatial/octree/octree.h"

namespace jalon {

/// A tree that answers nearest-point questions for another one and has no long runs of equal points: all points of such
/// a run are equally near, and a search that must name the first of them would look at all. Where there are none, it is
/// the tree itself.
class DistinctPoints {
 public:
  DistinctPoints(const Octree& all, Task& task);
  const Octree& tree() const { return thinned_ ? *thinned_ : all_; }
  /// The sorted position in the whole tree of a sorted position in tree().
  uint32_t position(uint32_t p) const { return thinned_ ? position_of_[thinned_->order()[p]] : p; }

 private:
  std::vector<uint32_t> repeating_leaves(Task& task) const;
  void thin(const std::vector<uint32_t>& leaves, Task& task);
  const Octree& all_;
  Buffer<double> xyz_;
  Buffer<uint32_t> position_of_;  ///< index in xyz_ -> sorted position in the whole tree
  std::shared_ptr<const Octree> thinned_;
};

}  // namespace jalon
