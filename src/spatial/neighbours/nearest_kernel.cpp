// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "spatial/neighbours/nearest_kernel.h"
#include "spatial/neighbours/nearest_kernel.inc"

namespace jalon {

bool gather_near_baseline(const OctreeView& tree, const GridMap& map, const GridBox& box,
                          const int32_t* anchor, NearCandidates& out) {
  return gather_near(tree, map, box, anchor, out);
}
void nearest_of_group_baseline(const NearCandidates& candidates, NearestGroup& group) {
  nearest_of_group(candidates, group);
}
void nearest_of_one_baseline(const OctreeView& tree, const GridMap& map, const int32_t* query,
                             float error, NearestOne& one) {
  nearest_of_one(tree, map, query, error, one);
}

}  // namespace jalon
