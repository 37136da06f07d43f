// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/landslide/moved_zones.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/distributions.h"
#include "base/parallel.h"
#include "compare/landslide/cell_map.h"

namespace jalon {

namespace {

constexpr size_t kZoneGrain = 1 << 13;
constexpr double kFewestCells = 3;  // of a zone: fewer are a boulder
constexpr double kMeanCells = 9;    // of a mean: as many cells make one test
constexpr int kRestMargin = 2;      // cells about a zone that do not count as ground at rest
constexpr int kFilledBy = 5;  // of the eight around: a measured cell between them is of their zone
constexpr int kHeldBy = 2;    // fewer around: a tip that noise made

/// One pass: zones by given errors.
class ZoneFinder {
 public:
  ZoneFinder(const VolumeGrid& grid, const GroundChange& change, const SmoothedChange& smooth,
             const LandslideSettings& settings, const GroundErrors& errors)
      : grid_(grid), change_(change), smooth_(smooth), settings_(settings), errors_(errors) {
    size_t measured = 0;
    for (size_t cell = 0; cell < change.difference.size(); ++cell)
      measured += change.is_measured(cell) ? 1 : 0;
    const double tests = std::max(1.0, static_cast<double>(measured) / kMeanCells);
    const double alpha = 1 - settings.confidence;
    core_ = normal_quantile(1 - alpha / tests / 2);
    grown_ = normal_quantile(1 - alpha / 2);
    own_ = normal_quantile(1 - alpha);  // of one sign
  }

  std::vector<uint32_t> labels(uint32_t& count, Task& task) const {
    std::vector<int8_t> sides = sides_of_cells(task);
    task.checkpoint(0.6);
    fill_and_trim(sides);
    task.checkpoint(0.8);
    return connected(sides, count);
  }

 private:
  // What all cells may be off together takes from a movement.
  double shared_m() const { return std::hypot(errors_.systematic_m, settings_.alignment_sigma_m); }
  double deviate(double difference, double sigma) const {
    return difference / std::hypot(errors_.scale * sigma, shared_m());
  }
  double smoothed_deviate(size_t cell) const {
    return smooth_.mean_m[cell] /
           std::hypot(errors_.smoothed_scale * smooth_.sigma_m[cell], shared_m());
  }

  // -1: down, 1: up, 0: neither. Grown from the cores cell by cell.
  std::vector<int8_t> sides_of_cells(Task& task) const {
    const size_t n = change_.difference.size();
    std::vector<int8_t> candidate(n, 0), out(n, 0);
    parallel_for(task, n, kZoneGrain, [&](size_t begin, size_t end) {
      for (size_t cell = begin; cell < end; ++cell) {
        if (!change_.is_measured(cell)) continue;
        const double mean = smoothed_deviate(cell),
                     own = deviate(change_.difference[cell], change_.sigma[cell]);
        candidate[cell] = mean > grown_ && own > own_ ? 1 : mean < -grown_ && own < -own_ ? -1 : 0;
        if (std::abs(mean) >= core_) out[cell] = candidate[cell];
      }
    });
    std::vector<size_t> open;
    for (size_t cell = 0; cell < n; ++cell)
      if (out[cell] != 0) open.push_back(cell);
    while (!open.empty()) {
      const size_t cell = open.back();
      open.pop_back();
      for_each_around(grid_, cell, [&](size_t other) {
        if (out[other] != 0 || candidate[other] != out[cell]) return;
        out[other] = out[cell];
        open.push_back(other);
      });
    }
    return out;
  }

  // A cell between many of a zone is of it, one that hardly hangs on it is not.
  void fill_and_trim(std::vector<int8_t>& sides) const {
    const std::vector<int8_t> before = sides;
    for (size_t cell = 0; cell < sides.size(); ++cell) {
      if (!change_.is_measured(cell)) continue;
      int up = 0, down = 0, known = 0;
      for_each_around(grid_, cell, [&](size_t other) {
        known += change_.is_measured(other) ? 1 : 0;
        up += before[other] > 0 ? 1 : 0;
        down += before[other] < 0 ? 1 : 0;
      });
      if (before[cell] == 0 && up >= kFilledBy) sides[cell] = 1;
      if (before[cell] == 0 && down >= kFilledBy) sides[cell] = -1;
      const int held = before[cell] > 0 ? up : down;
      if (before[cell] != 0 && known >= kFilledBy && held < kHeldBy) sides[cell] = 0;
    }
  }

  std::vector<uint32_t> connected(const std::vector<int8_t>& sides, uint32_t& count) const {
    std::vector<uint32_t> labels(sides.size(), 0);
    std::vector<size_t> sizes, open;
    for (size_t first = 0; first < sides.size(); ++first) {
      if (sides[first] == 0 || labels[first] != 0) continue;
      const auto label = static_cast<uint32_t>(sizes.size() + 1);
      sizes.push_back(0);
      labels[first] = label;
      open.push_back(first);
      while (!open.empty()) {
        const size_t cell = open.back();
        open.pop_back();
        ++sizes[label - 1];
        // Beside ground that was not measured it may be larger than what is seen of it.
        for_each_around(grid_, cell, [&](size_t other) {
          if (!change_.is_measured(other)) ++sizes[label - 1];
        });
        for_each_around(grid_, cell, [&](size_t other) {
          if (labels[other] != 0 || sides[other] != sides[cell]) return;
          labels[other] = label;
          open.push_back(other);
        });
      }
    }
    return ranked(std::move(labels), sizes, count);
  }

  // Most cells first, those beside it that were not measured among them, ties by the first cell; without the small.
  std::vector<uint32_t> ranked(std::vector<uint32_t> labels, const std::vector<size_t>& sizes,
                               uint32_t& count) const {
    const double cell_area = grid_.cell_m * grid_.cell_m;
    const double least =
        settings_.min_area_m2 > 0 ? settings_.min_area_m2 : kFewestCells * cell_area;
    std::vector<uint32_t> order(sizes.size()), rank(sizes.size() + 1, 0);
    std::iota(order.begin(), order.end(), 0u);
    std::stable_sort(order.begin(), order.end(),
                     [&](uint32_t a, uint32_t b) { return sizes[a] > sizes[b]; });
    count = 0;
    for (const uint32_t k : order)
      if (static_cast<double>(sizes[k]) * cell_area >= least) rank[k + 1] = ++count;
    for (uint32_t& label : labels) label = rank[label];
    return labels;
  }

  const VolumeGrid& grid_;
  const GroundChange& change_;
  const SmoothedChange& smooth_;
  const LandslideSettings& settings_;
  const GroundErrors& errors_;
  double core_ = 0, grown_ = 0, own_ = 0;
};

// Cells of a zone or near one.
std::vector<uint8_t> near_zones(const VolumeGrid& grid, std::span<const uint32_t> labels) {
  std::vector<uint8_t> out(labels.size(), 0);
  for (size_t cell = 0; cell < labels.size(); ++cell) out[cell] = labels[cell] != 0 ? 1 : 0;
  for (int step = 0; step < kRestMargin; ++step) {
    const std::vector<uint8_t> before = out;
    for (size_t cell = 0; cell < out.size(); ++cell) {
      if (before[cell] == 0) continue;
      for_each_around(grid, cell, [&](size_t other) { out[other] = 1; });
    }
  }
  return out;
}

}  // namespace

MovedZones moved_zones(const VolumeGrid& grid, const GroundChange& change,
                       const LandslideSettings& settings, Task& task) {
  const SmoothedChange smooth = smoothed(grid, change, task);
  MovedZones out;
  out.errors = ground_errors(grid, change, smooth, {});
  out.labels = ZoneFinder(grid, change, smooth, settings, out.errors).labels(out.count, task);
  constexpr int kPasses = 2;
  for (int pass = 0; pass < kPasses; ++pass) {
    out.errors = ground_errors(grid, change, smooth, near_zones(grid, out.labels));
    out.labels = ZoneFinder(grid, change, smooth, settings, out.errors).labels(out.count, task);
  }
  return out;
}

}  // namespace jalon
