// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/front/fronts.h"

#include <cmath>

#include "base/random.h"
#include "base/serial.h"
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

// One of every so many points, any of them, so that no row of a scan is left out; of small segments all.
ThinnedCloud thinned(const Cloud& cloud, std::span<const uint32_t> labels, size_t segments,
                     Task& task) {
  std::vector<size_t> points(segments + 1, 0);  // by label
  serial_for(task, labels.size(), kThinnedPerLook, [&](size_t begin, size_t end) {
    for (const uint32_t label : labels.subspan(begin, end - begin)) ++points[label];
  });
  const size_t step = (cloud.size() + kMostFrontPoints - 1) / kMostFrontPoints;
  RandomStream random(kThinningSeed, kThinningStream);
  std::vector<uint32_t> kept;
  size_t chosen = random.below(step);
  serial_for(task, cloud.size(), kThinnedPerLook, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      if (i == chosen || (labels[i] != 0 && points[labels[i]] < kLeastOfSegment))
        kept.push_back(static_cast<uint32_t>(i));
      if ((i + 1) % step == 0) chosen = i + 1 + random.below(step);
    }
  });
  Buffer<double> xyz(3 * kept.size());
  ThinnedCloud out;
  for (size_t k = 0; k < kept.size(); ++k) {
    const Vec3 p = cloud.point(kept[k]);
    for (int axis = 0; axis < 3; ++axis) xyz[3 * k + static_cast<size_t>(axis)] = p[axis];
    out.labels.push_back(labels[kept[k]]);
  }
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
