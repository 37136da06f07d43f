// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/detection/kept_cores.h"

#include <mutex>
#include <utility>

namespace jalon {

namespace {

class KeptCores : public IndexSlot::Remembered {
 public:
  explicit KeptCores(CorePair cores) : cores_(std::move(cores)) {}

  /// The other way round; of threads that ask at once the first one gets them.
  CorePair take(const Octree& reference, const Octree& compared, const Vec3& origin) {
    const std::lock_guard lock(mutex_);
    if (cores_.reference == nullptr || !cores_.reference->is_of(compared, origin) ||
        !cores_.compared->is_of(reference, origin))
      return {};
    return {std::exchange(cores_.compared, nullptr), std::exchange(cores_.reference, nullptr)};
  }

 private:
  std::mutex mutex_;
  CorePair cores_;
};

}  // namespace

CorePair take_kept_cores(const Cloud& reference, const Cloud& compared, const Vec3& origin,
                         Task& task) {
  const auto kept = std::dynamic_pointer_cast<KeptCores>(compared.index->remembered());
  if (kept == nullptr) return {};
  return kept->take(*reference.octree(task), *compared.octree(task), origin);
}

std::shared_ptr<const void> keep_cores(const Cloud& reference, CorePair cores) {
  const auto kept = std::make_shared<KeptCores>(std::move(cores));
  reference.index->remember(kept);
  return kept;
}

}  // namespace jalon
