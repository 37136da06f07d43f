// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/cells/flat_cells.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/parallel.h"
#include "spatial/octree/morton.h"

namespace jalon {

namespace {

constexpr double kFlatRoughness =
    0.42;  // rms in tolerances of what is a plane (as in extraction.cpp)
constexpr double kMostOutside = 0.02;  // share of a flat cell's points beyond the tolerance
constexpr double kMostFlatness = 0.1;  // smallest against middle eigenvalue: thicker is no sheet
constexpr size_t kFlatCellsPerChunk = 64;
constexpr double kMergeSigmas = 3;
constexpr double kCellRefit = 1.1;  // growth of the points after which the plane is fitted anew

struct CellRange {
  size_t first, last;
};

uint64_t prefix_of(const CellPoints& points, size_t position, int level) {
  return points.code(position) >> (3 * (kMaxLevel - level));
}

Moments moments_of(const CellPoints& points, const CellRange& cell) {
  Moments moments;
  const double half = points.tree.cube().edge / 2;
  moments.reference = {half, half, half};
  for (size_t i = cell.first; i < cell.last; ++i) moments.add(points.local(i));
  return moments;
}

bool is_flat(const CellPoints& points, const CellRange& cell, const SplitRule& rule,
             FlatCell& out) {
  out.moments = moments_of(points, cell);
  if (!fit_plane(out.moments, out.fit) || out.fit.sigma > kFlatRoughness * rule.tolerance_m ||
      out.fit.eigenvalues[0] > kMostFlatness * out.fit.eigenvalues[1])
    return false;
  size_t outside = 0;
  for (size_t i = cell.first; i < cell.last; ++i)
    outside += std::fabs(out.fit.plane.distance(points.local(i))) > rule.tolerance_m;
  return static_cast<double>(outside) <= kMostOutside * static_cast<double>(cell.last - cell.first);
}

// The occupied cells of the next level in one of this.
void add_children(const CellPoints& points, const CellRange& cell, int level,
                  std::vector<CellRange>& out) {
  size_t from = cell.first;
  while (from < cell.last) {
    const uint64_t own = prefix_of(points, from, level);
    size_t low = from + 1, high = cell.last;  // the first position of another child
    while (low < high) {
      const size_t middle = low + (high - low) / 2;
      if (prefix_of(points, middle, level) == own) low = middle + 1;
      else high = middle;
    }
    out.push_back({from, low});
    from = low;
  }
}

}  // namespace

std::vector<FlatCell> split_cells(const CellPoints& points, const SplitRule& rule, Task& task) {
  std::vector<CellRange> active{{0, points.size()}};
  std::vector<FlatCell> flat;
  for (int level = 0; level <= kMaxLevel && !active.empty(); ++level) {
    task.checkpoint(static_cast<double>(level) / kMaxLevel);
    const bool last =
        std::ldexp(points.tree.cube().edge, -level) <= rule.least_cell_m || level == kMaxLevel;
    std::vector<FlatCell> found(active.size());
    std::vector<uint8_t> is(active.size(), 0);
    const size_t grain = active.size() < 4096 ? 1 : kFlatCellsPerChunk;
    parallel_for(task, active.size(), grain, [&](size_t begin, size_t end) {
      for (size_t c = begin; c < end; ++c) {
        found[c].first = active[c].first;
        found[c].last = active[c].last;
        found[c].level = level;
        is[c] = active[c].last - active[c].first >= rule.least_points &&
                is_flat(points, active[c], rule, found[c]);
      }
    });
    std::vector<CellRange> next;
    for (size_t c = 0; c < active.size(); ++c) {
      if (is[c] != 0) flat.push_back(found[c]);
      else if (!last && active[c].last - active[c].first >= 2 * rule.least_points)
        add_children(points, active[c], level + 1, next);
    }
    active = std::move(next);
  }
  std::sort(flat.begin(), flat.end(),
            [](const FlatCell& a, const FlatCell& b) { return a.first < b.first; });
  return flat;
}

std::vector<std::vector<uint32_t>> touching_cells(const CellPoints& points,
                                                  const std::vector<FlatCell>& cells, Task& task) {
  // Codes at the finest level where the cells begin: they do not overlap, and stand in the order of the curve.
  std::vector<uint64_t> starts(cells.size());
  const auto shift = [](int level) { return 3 * (kMaxLevel - level); };
  for (size_t c = 0; c < cells.size(); ++c)
    starts[c] = prefix_of(points, cells[c].first, cells[c].level) << shift(cells[c].level);
  std::vector<std::vector<uint32_t>> larger(cells.size());  // neighbours at least as large
  parallel_for(task, cells.size(), kFlatCellsPerChunk, [&](size_t begin, size_t end) {
    for (size_t c = begin; c < end; ++c) {
      const int level = cells[c].level;
      const CellNumbers own = cell_numbers(starts[c] >> shift(level));
      const int64_t most = int64_t{1} << level;
      for (int k = 0; k < 27; ++k) {
        const int64_t p = int64_t{own.p} + k % 3 - 1, q = int64_t{own.q} + k / 3 % 3 - 1,
                      r = int64_t{own.r} + k / 9 - 1;
        if (k == 13 || p < 0 || q < 0 || r < 0 || p >= most || q >= most || r >= most) continue;
        const uint64_t code = morton_code(static_cast<uint32_t>(p), static_cast<uint32_t>(q),
                                          static_cast<uint32_t>(r))
                              << shift(level);
        const auto after = std::upper_bound(starts.begin(), starts.end(), code);
        if (after == starts.begin()) continue;
        const auto other = static_cast<size_t>(after - starts.begin() - 1);
        if (cells[other].level <= level &&
            starts[other] >> shift(cells[other].level) == code >> shift(cells[other].level))
          larger[c].push_back(static_cast<uint32_t>(other));
      }
    }
  });
  std::vector<std::vector<uint32_t>> touching = larger;
  for (uint32_t c = 0; c < cells.size(); ++c)
    for (const uint32_t other : larger[c]) touching[other].push_back(c);
  for (auto& list : touching) {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
  }
  return touching;
}

uint32_t merge_cells(const std::vector<FlatCell>& cells,
                     const std::vector<std::vector<uint32_t>>& touching, const MergeRule& rule,
                     std::vector<uint32_t>& labels, std::vector<Plane>& planes, Task& task) {
  std::vector<uint32_t> seeds(cells.size());
  std::iota(seeds.begin(), seeds.end(), 0u);
  std::stable_sort(seeds.begin(), seeds.end(),
                   [&](uint32_t a, uint32_t b) { return cells[a].moments.n > cells[b].moments.n; });
  labels.assign(cells.size(), 0);
  planes.clear();
  // Noise turns the plane of a small cell by its share of the width.
  const auto joins = [&](const FlatCell& cell, const Plane& plane) {
    if (std::fabs(plane.distance(cell.fit.centroid)) > rule.tolerance_m / 2) return false;
    if (rms_about(cell.moments, plane) > kFlatRoughness * rule.tolerance_m) return false;
    const double noise = kMergeSigmas * std::sqrt(cell.fit.local_covariance[3]);
    const double limit = std::min(1.5, rule.angle_rad + std::atan(noise));
    return std::fabs(dot(cell.fit.plane.normal, plane.normal)) >= std::cos(limit);
  };
  for (size_t s = 0; s < seeds.size(); ++s) {
    if (s % 4096 == 0) task.checkpoint(static_cast<double>(s) / static_cast<double>(seeds.size()));
    if (labels[seeds[s]] != 0) continue;
    const auto label = static_cast<uint32_t>(planes.size() + 1);
    Moments moments = cells[seeds[s]].moments;
    Plane plane = cells[seeds[s]].fit.plane;
    uint64_t fitted = moments.n;
    std::vector<uint32_t> region{seeds[s]};
    labels[seeds[s]] = label;
    for (size_t at = 0; at < region.size(); ++at)
      for (const uint32_t next : touching[region[at]]) {
        if (labels[next] != 0 || !joins(cells[next], plane)) continue;
        labels[next] = label;
        region.push_back(next);
        moments += cells[next].moments;
        PlaneFit fit;
        if (static_cast<double>(moments.n) < kCellRefit * static_cast<double>(fitted)) continue;
        fitted = moments.n;
        if (fit_plane(moments, fit)) plane = fit.plane;
      }
    planes.push_back(plane);
  }
  return static_cast<uint32_t>(planes.size());
}

}  // namespace jalon
