// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/lines/line_growth.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/parallel.h"

namespace jalon {

namespace {

constexpr uint64_t kWidestStep = 2;  // rows: one may hold no line
constexpr double kLineResidual =
    0.42;  // rms in tolerances of what is a plane (as in extraction.cpp)
constexpr size_t kLeastLines = 3;
constexpr double kLineRefit = 1.1;  // growth of the points after which the plane is fitted anew
constexpr double kFlatPair =
    1e-4;  // middle against largest eigenvalue of two lines that span a plane
constexpr size_t kLinesPerCheckpoint = 4096;

struct LineRow {
  uint64_t row;
  uint32_t first, last;
};

std::vector<LineRow> rows_of_lines(std::span<const ScanLine> lines) {
  std::vector<LineRow> rows;
  for (uint32_t i = 0; i < lines.size();) {
    const uint32_t first = i;
    while (i < lines.size() && lines[i].row == lines[first].row) ++i;
    rows.push_back({lines[first].row, first, i});
  }
  return rows;
}

class LineGrower {
 public:
  LineGrower(std::span<const ScanLine> lines, const std::vector<std::vector<uint32_t>>& beside,
             double tolerance_m, Task& task)
      : lines_(lines), beside_(beside), tolerance_m_(tolerance_m), task_(task) {
    regions_.labels.assign(lines.size(), 0);
    spent_.assign(lines.size(), 0);
  }

  LineRegions run() {
    std::vector<uint32_t> seeds(lines_.size());
    std::iota(seeds.begin(), seeds.end(), 0u);
    std::stable_sort(seeds.begin(), seeds.end(), [&](uint32_t a, uint32_t b) {
      return lines_[a].moments.n > lines_[b].moments.n;
    });
    for (size_t i = 0; i < seeds.size(); ++i) {
      if (i % kLinesPerCheckpoint == 0)
        task_.checkpoint(static_cast<double>(i) / static_cast<double>(seeds.size()));
      if (regions_.labels[seeds[i]] == 0 && spent_[seeds[i]] == 0) try_seed(seeds[i]);
    }
    return std::move(regions_);
  }

 private:
  void try_seed(uint32_t seed) {
    PlaneFit fit;
    uint32_t partner = seed;
    spent_[seed] = 1;
    if (!best_pair(seed, partner, fit)) return;
    const auto label = static_cast<uint32_t>(regions_.planes.size() + 1);
    std::vector<uint32_t> region{seed, partner};
    Moments moments = lines_[seed].moments;
    moments += lines_[partner].moments;
    Plane plane = fit.plane;
    uint64_t fitted = moments.n;
    regions_.labels[seed] = regions_.labels[partner] = label;
    for (size_t at = 0; at < region.size(); ++at)
      for (const uint32_t next : beside_[region[at]]) {
        if (regions_.labels[next] != 0 || !lies_in(lines_[next].moments, plane)) continue;
        regions_.labels[next] = label;
        region.push_back(next);
        moments += lines_[next].moments;
        if (static_cast<double>(moments.n) < kLineRefit * static_cast<double>(fitted)) continue;
        fitted = moments.n;
        if (fit_plane(moments, fit)) plane = fit.plane;
      }
    const bool good = region.size() >= kLeastLines && fit_plane(moments, fit) &&
                      fit.sigma <= kLineResidual * tolerance_m_;
    if (good) regions_.planes.push_back(fit.plane);
    else
      for (const uint32_t line : region) regions_.labels[line] = 0;
  }

  bool best_pair(uint32_t seed, uint32_t& partner, PlaneFit& best) const {
    double least = kLineResidual * tolerance_m_;
    for (const uint32_t other : beside_[seed]) {
      if (regions_.labels[other] != 0) continue;
      Moments both = lines_[seed].moments;
      both += lines_[other].moments;
      PlaneFit fit;
      if (!fit_plane(both, fit) || fit.eigenvalues[1] < kFlatPair * fit.eigenvalues[2]) continue;
      if (fit.sigma >= least) continue;
      least = fit.sigma;
      best = fit;
      partner = other;
    }
    return partner != seed;
  }

  bool lies_in(const Moments& line, const Plane& plane) const {
    return std::fabs(plane.distance(line.centroid())) <= tolerance_m_ / 2 &&
           rms_about(line, plane) <= kLineResidual * tolerance_m_;
  }

  std::span<const ScanLine> lines_;
  const std::vector<std::vector<uint32_t>>& beside_;
  double tolerance_m_;
  Task& task_;
  LineRegions regions_;
  std::vector<uint8_t> spent_;
};

}  // namespace

std::vector<std::vector<uint32_t>> lines_beside(std::span<const ScanLine> lines, Task& task) {
  const std::vector<LineRow> rows = rows_of_lines(lines);
  std::vector<std::vector<uint32_t>> beside(lines.size());
  // Upward in parallel: each row writes its own lists; downward after.
  parallel_for(task, rows.size(), 16, [&](size_t begin, size_t end) {
    for (size_t r = begin; r < end; ++r)
      for (size_t s = r + 1; s < rows.size() && rows[s].row - rows[r].row <= kWidestStep; ++s)
        for (uint32_t a = rows[r].first; a < rows[r].last; ++a)
          for (uint32_t b = rows[s].first; b < rows[s].last && lines[b].from <= lines[a].to; ++b)
            if (lines[b].to >= lines[a].from) beside[a].push_back(b);
  });
  std::vector<std::pair<uint32_t, uint32_t>> back;
  for (uint32_t a = 0; a < lines.size(); ++a)
    for (const uint32_t b : beside[a]) back.push_back({b, a});
  for (const auto& [b, a] : back) beside[b].push_back(a);
  for (auto& list : beside) std::sort(list.begin(), list.end());
  return beside;
}

LineRegions grow_lines(std::span<const ScanLine> lines,
                       const std::vector<std::vector<uint32_t>>& beside, double tolerance_m,
                       Task& task) {
  return LineGrower(lines, beside, tolerance_m, task).run();
}

}  // namespace jalon
