// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

#include "spatial/octree/view.h"

// The vector loops of the all-points search. Each is compiled for the baseline and for AVX2, with the same bits.

namespace jalon {

constexpr uint32_t kMostQueries =
    16;  ///< queries that share their candidates; at least kLeafPoints
constexpr uint32_t kMostCandidates = 2048;  ///< more: the queries are answered one by one

/// Candidates of a group of queries, grid coordinates; room for a vector more than kMostCandidates.
struct alignas(64) Candidates {
  int32_t x[kMostCandidates + 16], y[kMostCandidates + 16], z[kMostCandidates + 16];
  uint32_t position[kMostCandidates + 16];
  uint32_t count = 0;
};

/// A closed box, grid units.
struct GridBox {
  int32_t lo[3], hi[3];
};

/// The queries of a group and what comes out for each of them.
struct alignas(64) KnnGroup {
  int32_t x[kMostQueries], y[kMostQueries], z[kMostQueries];
  uint32_t count = 0;  ///< queries; the lanes behind them repeat the last one
  uint32_t k = 0;
  float covered = 0;  ///< squared distance up to which no candidate is missing
  float tie_slope =
      0;  ///< two distances closer than far * tie_slope + tie_root * root of the k-th + tie_floor
  float tie_root = 0;  ///< cannot be told apart: they are settled in doubles
  float tie_floor = 0;
  uint32_t index_bits = 0;  ///< low bits of a key that hold the candidate
  // Results: bit q for query q.
  uint32_t incomplete = 0, ambiguous = 0;
  uint32_t* keys = nullptr;  ///< [k + 1][kMostQueries], ascending; see knn_kernel.inc
};

constexpr uint32_t kNoKey = 0x7fffffff;  ///< as a float: not a number, so that no comparison holds

/// Appends the points in the box; false when there are more than kMostCandidates.
bool gather_candidates_baseline(const OctreeView& tree, const GridBox& box, Candidates& out);
bool gather_candidates_avx2(const OctreeView& tree, const GridBox& box, Candidates& out);
/// The k + 1 nearest candidates of every query of the group.
void knn_group_baseline(const Candidates& candidates, KnnGroup& group);
void knn_group_avx2(const Candidates& candidates, KnnGroup& group);
constexpr uint32_t kMostOnGrid = 257;  ///< points that are asked for at most
/// The size points nearest to a grid point by their distance on the grid, ascending; room for size in both. Places that
/// stay empty have infinity.
void nearest_on_grid_baseline(const OctreeView& tree, const int32_t* query, uint32_t size,
                              float* squared, uint32_t* position);
void nearest_on_grid_avx2(const OctreeView& tree, const int32_t* query, uint32_t size,
                          float* squared, uint32_t* position);

}  // namespace jalon
