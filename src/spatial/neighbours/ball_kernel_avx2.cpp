// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "spatial/neighbours/ball_kernel.h"
#include "spatial/neighbours/ball_kernel.inc"

namespace jalon {

bool gather_ball_candidates_avx2(const OctreeView& tree, const GridBox& box, BallCandidates& out) {
  return gather_ball_candidates(tree, box, out);
}
size_t points_in_ball_avx2(const BallCandidates& candidates, const Ball& ball, uint32_t* position,
                           float* squared, size_t& unsure) {
  return points_in_ball(candidates, ball, position, squared, unsure);
}

}  // namespace jalon
