// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/distance/closest_points.h"

#include <vector>

#include "base/error.h"
#include "cloud/operations.h"
#include "spatial/octree/octree.h"

namespace jalon {

Cloud closest_points(const Comparison& comparison, const Cloud& reference, Task& task) {
  std::vector<uint8_t> mask(reference.size());
  for (const uint32_t nearest : comparison.points.require("nearest").values<uint32_t>()) {
    if (nearest == kNoPoint) continue;
    if (nearest >= mask.size())
      fail(Status::kInvalidArgument,
           "the comparison was made with another reference: it names point %u of %zu", nearest,
           mask.size());
    mask[nearest] = 1;
  }
  return select_mask(reference, mask, 1, task);
}

}  // namespace jalon
