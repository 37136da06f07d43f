// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/memory_budget.h"
#include "base/parallel.h"
#include "base/random.h"
#include "base/setting_rows.h"
#include "cloud/operations.h"
#include "cloud/select.h"

namespace jalon {

namespace {

constexpr size_t kSubsampleGrain = 1 << 15;

/// Greedy in order of the points: whoever is still there stays, and sends all within the distance away.
Cloud at_minimum_distance(const Cloud& cloud, double distance_m, Task& task) {
  std::shared_ptr<const Octree> tree;
  {
    ProgressSpan span(task, 0, 0.2, "index");
    tree = cloud.octree(task);
  }
  std::vector<uint8_t> removed(cloud.size(), 0);
  {
    ProgressSpan span(task, 0.2, 0.9, "sampling");
    std::vector<Neighbour> close;
    constexpr size_t kCheckEvery =
        256;  // kept points: a few milliseconds unless the balls are huge
    size_t kept = 0;
    for (size_t i = 0; i < cloud.size(); ++i) {
      if (removed[i]) continue;
      if (kept++ % kCheckEvery == 0)
        task.checkpoint(static_cast<double>(i) / static_cast<double>(cloud.size()));
      tree->radius(cloud.point(i), distance_m, close);
      for (const Neighbour& neighbour : close)
        if (neighbour.index > i) removed[neighbour.index] = 1;
    }
  }
  ProgressSpan span(task, 0.9, 1, "copying");
  return select_mask(cloud, removed, 0, task);
}

/// Of a point that stays: its index, its coordinates and its fields.
uint64_t selected_row_bytes(const Cloud& cloud) {
  uint64_t bytes = sizeof(uint64_t) + 3 * sizeof(double);
  for (const ColumnPtr& column : cloud.fields)
    bytes += column->info().components * size_of(column->info().type);
  return bytes;
}

/// Each point draws a number; the points of the smallest ones stay, in their order.
Cloud at_random(const Cloud& cloud, uint64_t wanted, uint64_t seed, Task& task) {
  const size_t n = cloud.size();
  if (wanted >= n) return cloud;
  const auto draw = [&](size_t i) { return RandomStream(seed, i).bits(); };
  // The limit lies in one of 2^16 classes of draws; only that class has to be sorted.
  constexpr size_t kClasses = 1 << 16;
  struct Histogram {
    std::vector<uint32_t> counts;
    Histogram& operator+=(const Histogram& b) {
      if (counts.empty()) counts.assign(kClasses, 0);
      for (size_t c = 0; c < b.counts.size(); ++c) counts[c] += b.counts[c];
      return *this;
    }
  };
  const size_t grain = std::max<size_t>(n / 16 + 1, kClasses);
  constexpr uint64_t kHistogramBytes = kClasses * sizeof(uint32_t);
  require_memory(kHistogramBytes + std::max<uint64_t>(kHistogramBytes * ((n + grain - 1) / grain),
                                                      n + wanted * selected_row_bytes(cloud)));
  Histogram histogram;
  {
    ProgressSpan span(task, 0, 0.3, "sampling");
    histogram += parallel_reduce(task, n, grain, Histogram{}, [&](size_t begin, size_t end) {
      Histogram part{std::vector<uint32_t>(kClasses, 0)};
      for (size_t i = begin; i < end; ++i) ++part.counts[draw(i) >> 48];
      return part;
    });
  }
  size_t border = 0;
  uint64_t below = 0;
  while (below + histogram.counts[border] < wanted) below += histogram.counts[border++];
  std::vector<uint8_t> keep(n);
  std::vector<std::pair<uint64_t, size_t>> ties;  // the border class
  ProgressSpan span(task, 0.3, 1, "sampling");
  parallel_for(task, n, kSubsampleGrain, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      const uint64_t drawn = draw(i) >> 48;
      keep[i] = drawn < border ? 1 : drawn == border ? 2 : 0;
    }
  });
  for (size_t i = 0; i < n; ++i)
    if (keep[i] == 2) {
      ties.emplace_back(draw(i), i);
      keep[i] = 0;
    }
  std::sort(ties.begin(), ties.end());
  for (size_t t = 0; t < wanted - below; ++t) keep[ties[t].second] = 1;
  return select_mask(cloud, keep, 1, task);
}

uint64_t wanted_count(const Cloud& cloud, const SubsampleSettings& settings) {
  if (settings.count > 0) return settings.count;
  return static_cast<uint64_t>(std::llround(settings.fraction * static_cast<double>(cloud.size())));
}

}  // namespace

std::span<const ParamRow> subsample_rows() {
  using S = SubsampleSettings;
  static constexpr auto kRows = setting_rows(
      choice_row<&S::method>("method", "voxel|minimum_distance|random|octree", "",
                             "voxel: one point a grid cell; minimum_distance: no two closer; "
                             "random: a share or number; octree: one a cell"),
      number_row<&S::cell_m>("cell_m", 1e-6, 1e6, "m", "voxel", "Edge length of the grid cells"),
      choice_row<&S::keep>(
          "keep", "centroid|nearest", "voxel,octree",
          "centroid: a new point amid the cell's points, with the fields of the one nearest to it; "
          "nearest: the original point nearest to the cell's centre"),
      number_row<&S::distance_m>("distance_m", 1e-9, 1e6, "m", "minimum_distance",
                                 "Kept points lie farther apart than this; every removed one lies "
                                 "within it of a kept one (a radius)"),
      number_row<&S::fraction>("fraction", 0, 1, "1", "random",
                               "Share of the points to keep; not read when count is above 0"),
      integer_row<&S::count>("count", 0, 1e15, "points", "random",
                             "Number of points to keep; 0 = use fraction"),
      integer_row<&S::seed>("seed", 0, 0x1p53, "", "random",
                            "Another seed gives another choice; the same one the same choice"),
      integer_row<&S::level>("level", -1, kMaxLevel, "", "octree",
                             "Octree level whose cells give one point each: 0 = the whole cube ... "
                             "21 = smallest cells; -1 = use max_points"),
      integer_row<&S::max_points>(
          "max_points", 1, 1e15, "points", "octree",
          "For level = -1: the deepest level with at most this many occupied cells"));
  return kRows;
}

Cloud subsampled(const Cloud& cloud, const SubsampleSettings& settings, Task& task) {
  using Method = SubsampleSettings::Method;
  const SubsampleSettings& s = settings;
  if (cloud.size() == 0) return cloud;
  switch (s.method) {
    case Method::kMinimumDistance:
      return at_minimum_distance(cloud, s.distance_m, task);
    case Method::kRandom:
      return at_random(cloud, wanted_count(cloud, s), s.seed, task);
    case Method::kOctree:
      return one_per_octree_cell(cloud, s.level, s.max_points, s.keep, task);
    case Method::kVoxel:
      break;
  }
  return one_per_voxel(cloud, s.cell_m, s.keep, task);
}

}  // namespace jalon
