// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/task.h"
#include "registration/coarse/feature_match.h"
#include "registration/coarse/surface.h"

namespace jalon {

/// Which matches can be right together: a rigid motion keeps distances, so the two points of one
/// match lie as far apart in both clouds (Chen et al. 1999; Yang, Shi & Carlone 2021), and their
/// normals stand alike to each other.
///
/// Nodes are matches by their index; edges are symmetric and none is of a match to itself. Cliques
/// hold an edge between each two of their nodes, the seed first. Greedy, so not always the largest
/// ones; deterministic. O(n^2) bits and time for n matches.
class MatchGraph {
 public:
  /// tolerance_m: of the distances; nearest_m: pairs nearer than this say nothing about a turn and are no edges.
  MatchGraph(std::span<const FeatureMatch> matches, const CoarseSurface& reference,
             const CoarseSurface& moving, double tolerance_m, double nearest_m, Task& task);

  size_t size() const { return count_; }
  size_t degree(size_t i) const { return degrees_[i]; }
  /// Matches of a large clique around this one, itself first: greedily the one next that keeps most in common.
  std::vector<uint32_t> clique(size_t seed) const;
  /// Cliques of the best seeds, each from a seed that is in none before; those of fewer than `least` are left out.
  std::vector<std::vector<uint32_t>> cliques(size_t most, size_t least, Task& task) const;

 private:
  const uint64_t* row(size_t i) const { return bits_.data() + i * words_; }
  size_t common(const uint64_t* a, const uint64_t* b) const;

  size_t count_, words_;
  std::vector<uint64_t> bits_;
  std::vector<uint32_t> degrees_;
};

}  // namespace jalon
