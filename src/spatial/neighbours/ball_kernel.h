// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

#include "spatial/neighbours/knn_kernel.h"
#include "spatial/octree/view.h"

// The vector loops of the search for all points in a ball. Each is compiled for the baseline and for AVX2, with the
// same bits.

namespace jalon {

/// Points that may lie in the balls of a group, grid coordinates, ascending positions. Arrays of the caller with room
/// for a vector more than count.
struct BallCandidates {
  int32_t *x, *y, *z;
  uint32_t* position;
  size_t count;
  size_t room;  ///< without that vector
};

/// One ball: squared distances on the grid up to surely are inside, beyond perhaps outside.
struct Ball {
  int32_t x, y, z;
  float surely, perhaps;
};

/// Appends the points of the box; false when there is no room.
bool gather_ball_candidates_baseline(const OctreeView& tree, const GridBox& box,
                                     BallCandidates& out);
bool gather_ball_candidates_avx2(const OctreeView& tree, const GridBox& box, BallCandidates& out);
/// Writes positions and squared distances of the candidates up to ball.perhaps, both with room for a vector more than
/// all of them; returns how many. unsure: how many of them are beyond ball.surely.
size_t points_in_ball_baseline(const BallCandidates& candidates, const Ball& ball,
                               uint32_t* position, float* squared, size_t& unsure);
size_t points_in_ball_avx2(const BallCandidates& candidates, const Ball& ball, uint32_t* position,
                           float* squared, size_t& unsure);

}  // namespace jalon
