// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "spatial/neighbours/knn_kernel.h"
#include "spatial/neighbours/knn_kernel.inc"

namespace jalon {

bool gather_candidates_baseline(const OctreeView& tree, const GridBox& box, Candidates& out) {
  return gather(tree, box, out);
}
void knn_group_baseline(const Candidates& candidates, KnnGroup& group) {
  search(candidates, group);
}
void nearest_on_grid_baseline(const OctreeView& tree, const int32_t* query, uint32_t size,
                              float* squared, uint32_t* position) {
  NearestList list(size);
  nearest(tree, query, list);
  list.copy(squared, position);
}

}  // namespace jalon
