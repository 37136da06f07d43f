// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/distance/nearest_groups.h"

#include <vector>

#include "base/parallel.h"
#include "spatial/octree/octree.h"
#include "spatial/partition.h"

namespace jalon {

// A counting sort in two moves, so that the counters of each stay in the cache: queries to stretches of positions, then
// within each stretch.
NearestGroups::NearestGroups(std::span<const uint32_t> nearest, size_t references, Task& task)
    : queries_(nearest.size()), begins_(references + 1) {
  struct Pair {
    uint32_t position, query;
  };
  constexpr size_t kMostStretches = 4096;
  int shift = 8;
  while ((references >> shift) >= kMostStretches) ++shift;
  const size_t stretches = (references >> shift) + 1;
  Buffer<Pair> pairs(nearest.size());
  const auto begins = partition(
      nearest.size(), stretches + 1,
      [&](const Pair& p) {
        return p.position == kNoPoint ? stretches : size_t{p.position} >> shift;
      },
      task, pairs.data(),
      [&](size_t i) {
        return Pair{nearest[i], static_cast<uint32_t>(i)};
      });
  begins_[references] = static_cast<uint32_t>(begins[stretches]);
  const auto groups = groups_of(stretches, size_t{1} << 14,
                                [&](size_t s) { return begins[s + 1] - begins[s] + 64; });
  const size_t width = size_t{1} << shift;
  parallel_chunks(task, groups.size() - 1, [&](size_t g) {
    std::vector<uint32_t> next(width + 1);
    for (size_t s = groups[g]; s < groups[g + 1]; ++s) {
      const size_t first = s << shift, last = std::min(references, first + width);
      std::fill(next.begin(), next.end(), 0);
      for (size_t i = begins[s]; i < begins[s + 1]; ++i) ++next[pairs[i].position - first + 1];
      next[0] = static_cast<uint32_t>(begins[s]);
      for (size_t p = first; p < last; ++p) {
        begins_[p] = next[p - first];
        next[p - first + 1] += next[p - first];
      }
      for (size_t i = begins[s]; i < begins[s + 1]; ++i)
        queries_[next[pairs[i].position - first]++] = pairs[i].query;
    }
  });
}

}  // namespace jalon
