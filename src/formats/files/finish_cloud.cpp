// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "formats/files/finish_cloud.h"

#include <cmath>

#include "base/error.h"
#include "base/parallel.h"

namespace jalon {

Cloud finish_cloud(Cloud cloud, const ByteSource& source, bool drop_invalid, Task& task) {
  constexpr size_t kFiniteGrain = size_t{1} << 17;
  const std::span<const double> xyz = cloud.xyz();
  const auto finite = [&](size_t i) {
    return std::isfinite(xyz[3 * i]) && std::isfinite(xyz[3 * i + 1]) &&
           std::isfinite(xyz[3 * i + 2]);
  };
  ProgressSpan span(task, 0.95, 1);
  const uint64_t bad =
      parallel_reduce<uint64_t>(task, cloud.size(), kFiniteGrain, 0, [&](size_t begin, size_t end) {
        uint64_t count = 0;
        for (size_t i = begin; i < end; ++i) count += finite(i) ? 0 : 1;
        return count;
      });
  if (bad == 0) return cloud;
  std::vector<uint64_t> kept;
  if (drop_invalid) kept.reserve(cloud.size() - bad);
  for (size_t i = 0; i < cloud.size(); ++i) {
    if (finite(i)) {
      if (drop_invalid) kept.push_back(i);
    } else if (!drop_invalid) {
      fail(Status::kFormat,
           "%s: point %zu has a coordinate that is not finite (%llu of %zu have); drop_invalid "
           "leaves them out",
           source.path().c_str(), i, static_cast<unsigned long long>(bad), cloud.size());
    }
  }
  task.log(Task::kWarning, "%s: %llu points with coordinates that are not finite left out",
           source.path().c_str(), static_cast<unsigned long long>(bad));
  return select(cloud, kept, task);
}

}  // namespace jalon
