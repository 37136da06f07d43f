// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/distance/hausdorff.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>

#include "base/table_columns.h"
#include "spatial/neighbours/nearest.h"

namespace jalon {

double directed_hausdorff(const Octree& from, const Octree& to, Task& task) {
  double largest = 0;  // the largest is the same in whatever order they come
  std::mutex mutex;
  for_each_nearest(
      to, from, std::numeric_limits<double>::infinity(), task, [&](const NearestBatch& batch) {
        const double most = *std::max_element(batch.squared, batch.squared + batch.count);
        const std::lock_guard lock(mutex);
        largest = std::max(largest, most);
      });
  return std::sqrt(largest);
}

void add_hausdorff(const Octree& reference, const Octree& compared, Task& task,
                   FieldTable& summary) {
  double forward, reverse;
  {
    ProgressSpan span(task, 0, 0.5, "Hausdorff distance");
    forward = directed_hausdorff(compared, reference, task);
  }
  ProgressSpan span(task, 0.5, 1);
  reverse = directed_hausdorff(reference, compared, task);
  add_value<double>(summary, "hausdorff_forward", "m",
                    "largest distance of a compared point from the reference points", forward);
  add_value<double>(summary, "hausdorff_reverse", "m",
                    "largest distance of a reference point from the compared points", reverse);
  add_value<double>(summary, "hausdorff", "m",
                    "the larger of both: the symmetric Hausdorff distance",
                    std::max(forward, reverse));
}

}  // namespace jalon
