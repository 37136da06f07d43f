// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/coarse/feature_match.h"

#include <algorithm>
#include <array>

#include "base/parallel.h"

namespace jalon {

namespace {

constexpr size_t kLanes = 8;
constexpr size_t kFeatureMatchGrain = 32;

/// Features of distinct points side by side, so that one is compared with eight at once.
class FeatureLanes {
 public:
  explicit FeatureLanes(const CoarseSurface& s)
      : count_(s.distinct.size()), values_((count_ + kLanes - 1) / kLanes * kLanes * kFeatureSize) {
    for (size_t i = 0; i < count_; ++i)
      for (size_t k = 0; k < kFeatureSize; ++k)
        values_[(i / kLanes * kFeatureSize + k) * kLanes + i % kLanes] =
            s.features[s.distinct[i]][k];
  }
  size_t size() const { return count_; }
  void distances(const Feature& f, std::vector<float>& out) const {
    out.resize((count_ + kLanes - 1) / kLanes * kLanes);
    for (size_t block = 0; block * kLanes < count_; ++block) {
      const float* v = values_.data() + block * kFeatureSize * kLanes;
      std::array<float, kLanes> sum{};
      for (size_t k = 0; k < kFeatureSize; ++k)
        for (size_t lane = 0; lane < kLanes; ++lane) {
          const float d = f[k] - v[k * kLanes + lane];
          sum[lane] += d * d;
        }
      std::copy(sum.begin(), sum.end(), out.begin() + static_cast<ptrdiff_t>(block * kLanes));
    }
  }

 private:
  size_t count_;
  std::vector<float> values_;
};

struct Near {
  float distance;
  uint32_t index;
  bool operator<(const Near& b) const {
    return distance != b.distance ? distance < b.distance : index < b.index;
  }
};

// For each distinct point the `rank` nearest of the lanes.
std::vector<std::vector<Near>> nearest_features(const CoarseSurface& s, const FeatureLanes& lanes,
                                                size_t rank, Task& task) {
  std::vector<std::vector<Near>> out(s.distinct.size());
  parallel_for(task, out.size(), kFeatureMatchGrain, [&](size_t begin, size_t end) {
    std::vector<float> distances;
    for (size_t i = begin; i < end; ++i) {
      lanes.distances(s.features[s.distinct[i]], distances);
      std::vector<Near>& best = out[i];
      for (uint32_t j = 0; j < lanes.size(); ++j) {
        const Near near{distances[j], j};
        if (best.size() == rank && !(near < best.back())) continue;
        if (best.size() == rank) best.pop_back();
        best.insert(std::upper_bound(best.begin(), best.end(), near), near);
      }
    }
  });
  return out;
}

}  // namespace

std::vector<FeatureMatch> match_features(const CoarseSurface& reference,
                                         const CoarseSurface& moving, size_t rank, size_t most,
                                         Task& task) {
  const FeatureLanes reference_lanes(reference), moving_lanes(moving);
  const auto forth = nearest_features(moving, reference_lanes, rank, task);
  const auto back = nearest_features(reference, moving_lanes, rank, task);
  std::vector<FeatureMatch> out;
  for (uint32_t i = 0; i < forth.size(); ++i)
    for (const Near& near : forth[i]) {
      const auto& others = back[near.index];
      const bool is_mutual =
          std::any_of(others.begin(), others.end(), [&](const Near& n) { return n.index == i; });
      if (is_mutual)
        out.push_back({moving.distinct[i], reference.distinct[near.index], near.distance});
    }
  std::stable_sort(out.begin(), out.end(), [](const FeatureMatch& a, const FeatureMatch& b) {
    return a.distance < b.distance;
  });
  if (out.size() > most) out.resize(most);
  return out;
}

}  // namespace jalon
