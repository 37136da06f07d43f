// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/front/fronts.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"
#include "base/random.h"
#include "segment/front/free_space.h"
#include "segment/front/near_wall.h"
#include "segment/front/shared_viewers.h"
#include "segment/front/side.h"

namespace jalon {

namespace {

// What lies about walls is judged by cells of their own spacing, 0.04 m and wider: points beyond these lie where
// others do, and each wall goes through all of them.
constexpr size_t kMostFrontPoints = 1 << 20;
constexpr size_t kLeastOfSegment = 1000;  // points: segments of fewer keep all of them
constexpr size_t kThinnedPerLook = 1 << 18;
constexpr uint64_t kThinningSeed = 1, kThinningStream = 1;

/// A part of a large cloud, with its labels.
struct ThinnedCloud {
  Cloud cloud;
  std::vector<uint32_t> labels;
};

// How many points have each label.
struct LabelCounts {
  std::vector<size_t> of;
  LabelCounts& operator+=(const LabelCounts& b) {
    for (size_t k = 0; k < of.size(); ++k) of[k] += b.of[k];
    return *this;
  }
};

LabelCounts count_labels(std::span<const uint32_t> labels, size_t segments, Task& task) {
  const LabelCounts zero{std::vector<size_t>(segments + 1, 0)};
  return parallel_reduce(task, labels.size(), kThinnedPerLook, zero, [&](size_t begin, size_t end) {
    LabelCounts part = zero;
    for (const uint32_t label : labels.subspan(begin, end - begin)) ++part.of[label];
    return part;
  });
}

// One of every so many points, any of them, so that no row of a scan is left out; of small segments all.
std::vector<uint32_t> chosen_points(std::span<const uint32_t> labels, size_t segments, Task& task) {
  const size_t n = labels.size(), step = (n + kMostFrontPoints - 1) / kMostFrontPoints;
  const LabelCounts points = count_labels(labels, segments, task);
  RandomStream random(kThinningSeed, kThinningStream);
  std::vector<uint32_t> chosen;  // of each run of `step` points
  for (size_t first = 0; first < n; first += step)
    chosen.push_back(static_cast<uint32_t>(first + random.below(step)));
  std::vector<std::vector<uint32_t>> parts((n + kThinnedPerLook - 1) / kThinnedPerLook);
  parallel_for(task, n, kThinnedPerLook, [&](size_t begin, size_t end) {
    std::vector<uint32_t>& kept = parts[begin / kThinnedPerLook];
    auto next = std::lower_bound(chosen.begin(), chosen.end(), begin);
    for (size_t i = begin; i < end; ++i) {
      const bool is_chosen = next != chosen.end() && *next == i;
      if (is_chosen) ++next;
      if (is_chosen || (labels[i] != 0 && points.of[labels[i]] < kLeastOfSegment))
        kept.push_back(static_cast<uint32_t>(i));
    }
  });
  std::vector<uint32_t> out;
  for (const auto& part : parts) out.insert(out.end(), part.begin(), part.end());
  return out;
}

ThinnedCloud thinned(const Cloud& cloud, std::span<const uint32_t> labels, size_t segments,
                     Task& task) {
  const std::vector<uint32_t> kept = chosen_points(labels, segments, task);
  Buffer<double> xyz(3 * kept.size());
  ThinnedCloud out;
  out.labels.resize(kept.size());
  parallel_for(task, kept.size(), kThinnedPerLook, [&](size_t begin, size_t end) {
    for (size_t k = begin; k < end; ++k) {
      const Vec3 p = cloud.point(kept[k]);
      for (int axis = 0; axis < 3; ++axis) xyz[3 * k + static_cast<size_t>(axis)] = p[axis];
      out.labels[k] = labels[kept[k]];
    }
  });
  out.cloud = make_cloud(std::move(xyz));
  return out;
}

std::vector<WallFront> fronts_of(std::vector<WallGroup> groups, const Cloud& cloud,
                                 const Vec3& origin, std::span<const uint32_t> labels,
                                 const std::vector<Segment>& segments, Task& task) {
  std::vector<WallFront> out;
  const SparsePlaces places = sparse_places(cloud, origin, task);
  std::vector<WallSheet> sheets;
  std::vector<double> log_odds;
  for (WallGroup& group : groups) {
    const WallSheet& sheet = sheets.emplace_back(cloud, origin, labels, segments, group, task);
    FrontEvidence evidence;
    look_near(cloud, origin, labels, segments, group, sheet, evidence, task);
    look_through(places, sheet, evidence, task);
    log_odds.push_back(front_log_odds(evidence));
    WallFront& front = out.emplace_back();
    front.evidence = evidence;
    front.group = std::move(group);
  }
  share_viewers(sheets, log_odds);
  for (size_t g = 0; g < out.size(); ++g) {
    out[g].log_odds = log_odds[g];
    out[g].viewer = viewer_before(sheets[g], out[g].is_before() ? 1 : -1);
  }
  return out;
}

}  // namespace

double WallFront::confidence() const { return probability_of(std::fabs(log_odds)); }

std::vector<WallFront> wall_fronts(const Cloud& cloud, const Vec3& origin,
                                   std::span<const uint32_t> labels,
                                   const std::vector<Segment>& segments, Task& task) {
  std::vector<WallGroup> groups = wall_groups(segments);
  if (groups.empty()) return {};
  if (cloud.size() <= kMostFrontPoints)
    return fronts_of(std::move(groups), cloud, origin, labels, segments, task);
  const ThinnedCloud few = thinned(cloud, labels, segments.size(), task);
  return fronts_of(std::move(groups), few.cloud, origin, few.labels, segments, task);
}

}  // namespace jalon
