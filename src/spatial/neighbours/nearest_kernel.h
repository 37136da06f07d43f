// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

#include "spatial/neighbours/knn_kernel.h"
#include "spatial/octree/view.h"

// The vector loops of the nearest-neighbour search between two trees. Each is compiled for the baseline and for AVX2,
// with the same bits.
//
// Both trees are seen in one frame of whole steps, the frame of the search, in which all coordinates lie in [0, 2^31).

namespace jalon {

constexpr uint32_t kMostNear =
    512;  ///< candidates of a group; more: the queries are answered one by one

/// How a tree's grid lies in the frame of a search: coordinate = (grid >> shift) + offset.
struct GridMap {
  int32_t shift = 0;
  int32_t offset[3] = {0, 0, 0};
};

/// Candidates of a group relative to its anchor; room for a vector more than kMostNear.
struct alignas(64) NearCandidates {
  float x[kMostNear + 16], y[kMostNear + 16], z[kMostNear + 16];
  uint32_t position[kMostNear + 16];
  uint32_t count = 0;
};

/// Queries of a group, relative to its anchor, and for each the squared distances of the nearest and the second nearest
/// candidate (infinity where there are none) and the number of the nearest, the first of equal ones.
struct alignas(64) NearestGroup {
  float x[kMostQueries], y[kMostQueries],
      z[kMostQueries];  ///< the lanes behind count repeat the last query
  uint32_t count = 0;
  float best[kMostQueries], second[kMostQueries];
  uint32_t candidate[kMostQueries];
};

/// What is known of one query: squared distances of the nearest point so far and of the second.
struct NearestOne {
  float best, second;
  uint32_t position;
};

/// Appends the points of the box (in the tree's own grid); false when there are more than kMostNear.
bool gather_near_baseline(const OctreeView& tree, const GridMap& map, const GridBox& box,
                          const int32_t* anchor, NearCandidates& out);
bool gather_near_avx2(const OctreeView& tree, const GridMap& map, const GridBox& box,
                      const int32_t* anchor, NearCandidates& out);
void nearest_of_group_baseline(const NearCandidates& candidates, NearestGroup& group);
void nearest_of_group_avx2(const NearCandidates& candidates, NearestGroup& group);
/// The nearest point of one query (frame of the search), if it is nearer than one.best; the second is right where it is
/// within error (steps) of the best.
void nearest_of_one_baseline(const OctreeView& tree, const GridMap& map, const int32_t* query,
                             float error, NearestOne& one);
void nearest_of_one_avx2(const OctreeView& tree, const GridMap& map, const int32_t* query,
                         float error, NearestOne& one);

}  // namespace jalon
