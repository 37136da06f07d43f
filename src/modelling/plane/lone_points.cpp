// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/plane/lone_points.h"

#include <atomic>

#include "base/parallel.h"
#include "spatial/octree/other_within.h"

namespace jalon {

namespace {

constexpr size_t kLoneGrain = 1 << 14;
// So many points before and behind on the curve are looked at before the tree is asked, which takes far longer.
constexpr size_t kOnCurve = 8;

}  // namespace

LonePoints::LonePoints(const Cloud& cloud, std::span<const uint32_t> labels, double near_m,
                       Task& task)
    : bits_((cloud.size() + 63) / 64) {
  const auto tree = cloud.octree(task);
  const auto order = tree->order();
  const double near2 = near_m * near_m;
  parallel_for(task, order.size(), kLoneGrain, [&](size_t begin, size_t end) {
    for (size_t s = begin; s < end; ++s) {
      const uint32_t i = order[s];
      if (labels[i] != 0) continue;
      const Vec3 p = cloud.point(i);
      // One that follows on the curve is near nearly always: few are searched for.
      const auto is_near = [&](size_t at) {
        return at < order.size() && squared_norm(cloud.point(order[at]) - p) <= near2;
      };
      bool has_near = false;
      for (size_t k = 1; k <= kOnCurve && !has_near; ++k)
        has_near = (s >= k && is_near(s - k)) || is_near(s + k);
      if (has_near || has_other_within(*tree, s, near_m)) continue;
      std::atomic_ref<uint64_t>(bits_[i / 64])
          .fetch_or(uint64_t{1} << i % 64, std::memory_order_relaxed);
    }
  });
}

}  // namespace jalon
