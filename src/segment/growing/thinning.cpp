// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/growing/thinning.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"

namespace jalon {

namespace {

// Thinning pays when it leaves less than this share; a second tree for a few points less would cost more than they.
constexpr double kThinnedShare = 0.7;
constexpr size_t kThinnedPointsPerChunk = 1 << 15;

std::vector<uint32_t> free_points(const SegmentScene& scene) {
  std::vector<uint32_t> out;
  for (size_t i = 0; i < scene.size(); ++i)
    if (scene.owner[i] == 0) out.push_back(static_cast<uint32_t>(i));
  return out;
}

GrowingPoints subset(const SegmentScene& scene, const std::vector<uint32_t>& chosen, Task& task) {
  GrowingPoints points;
  points.xyz = Buffer<double>(3 * chosen.size());
  parallel_for(task, chosen.size(), kThinnedPointsPerChunk, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      const Vec3 p = scene.cloud.point(scene.order[chosen[i]]);
      for (int k = 0; k < 3; ++k) points.xyz[3 * i + static_cast<size_t>(k)] = p[k];
    }
  });
  points.tree = Octree::build({points.xyz.data(), points.xyz.size()}, scene.tree->cube(), task);
  points.positions.resize(chosen.size());
  for (size_t i = 0; i < chosen.size(); ++i) points.positions[i] = chosen[points.tree->order()[i]];
  return points;
}

}  // namespace

Representatives one_per_cell(const SegmentScene& scene, Task& task) {
  const double finest = std::log2(scene.tree->cube().edge / scene.settings.distance_tolerance_m);
  const int level = std::clamp(static_cast<int>(std::ceil(finest)), 0, kMaxLevel);
  const auto cell = [&](size_t i) { return scene.tree->code(i) >> (3 * (kMaxLevel - level)); };
  const size_t n = scene.size();
  std::vector<Representatives> parts((n + kThinnedPointsPerChunk - 1) / kThinnedPointsPerChunk);
  parallel_for(task, n, kThinnedPointsPerChunk, [&](size_t begin, size_t end) {
    Representatives& part = parts[begin / kThinnedPointsPerChunk];
    size_t i = begin;
    if (begin > 0)  // a cell belongs to the chunk that holds its first point
      for (const uint64_t before = cell(begin - 1); i < end && cell(i) == before;) ++i;
    std::vector<uint32_t> free;
    while (i < end) {
      const size_t first = i;
      free.clear();
      for (const uint64_t own = cell(first); i < n && cell(i) == own; ++i)
        if (scene.owner[i] == 0) free.push_back(static_cast<uint32_t>(i));
      if (free.empty()) continue;
      part.free += free.size();
      part.first.push_back(static_cast<uint32_t>(first));
      part.points.push_back(free[free.size() / 2]);
    }
  });
  Representatives all;
  for (const Representatives& part : parts) {
    all.free += part.free;
    all.points.insert(all.points.end(), part.points.begin(), part.points.end());
    all.first.insert(all.first.end(), part.first.begin(), part.first.end());
  }
  return all;
}

bool pays(const Representatives& cells) {
  return static_cast<double>(cells.points.size()) < kThinnedShare * static_cast<double>(cells.free);
}

GrowingPoints thinned_points(const SegmentScene& scene, const Representatives& cells, Task& task) {
  GrowingPoints points = pays(cells)                  ? subset(scene, cells.points, task)
                         : cells.free == scene.size() ? GrowingPoints{.tree = scene.tree}
                                                      : subset(scene, free_points(scene), task);
  points.points_per_member =
      static_cast<double>(cells.free) / static_cast<double>(points.tree->size());
  return points;
}

}  // namespace jalon
