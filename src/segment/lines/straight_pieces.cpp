// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/lines/straight_pieces.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"

namespace jalon {

namespace {

constexpr double kStepsPerGap = 5;       // of gap_m = 0: the upper end of 3 to 5 spacings
constexpr size_t kScanRowsPerChunk = 4;  // a row has some thousand points

struct RowRange {
  uint32_t first, last;
};

std::vector<RowRange> rows_of(std::span<const ScanPlace> places) {
  std::vector<RowRange> rows;
  for (uint32_t i = 0; i < places.size();) {
    const uint32_t first = i;
    while (i < places.size() && places[i].row == places[first].row) ++i;
    rows.push_back({first, i});
  }
  return rows;
}

double median_step(std::span<const Vec3> points) {
  std::vector<double> steps;
  for (size_t i = 1; i < points.size(); ++i) steps.push_back(norm(points[i] - points[i - 1]));
  const auto middle = steps.begin() + static_cast<ptrdiff_t>(steps.size() / 2);
  std::nth_element(steps.begin(), middle, steps.end());
  return *middle;
}

class RowCutter {
 public:
  RowCutter(const SegmentScene& scene, std::span<const ScanPlace> places,
            std::span<const uint32_t> positions, const ScanLineSettings& settings)
      : scene_(scene), places_(places), positions_(positions), settings_(settings) {
    const double half = scene.tree->cube().edge / 2;
    reference_ = {half, half, half};
  }

  void cut(const RowRange& row, std::vector<ScanLine>& out) const {
    std::vector<Vec3> points;
    for (uint32_t i = row.first; i < row.last; ++i)
      points.push_back(scene_.local(positions_[places_[i].point]));
    if (points.size() < settings_.line_points) return;
    const double gap = settings_.gap_m > 0 ? settings_.gap_m : kStepsPerGap * median_step(points);
    size_t begin = 0;
    for (size_t i = 1; i <= points.size(); ++i) {
      if (i < points.size() && norm(points[i] - points[i - 1]) <= gap) continue;
      cut_chain(row, {points.data() + begin, i - begin}, begin, out);
      begin = i;
    }
  }

 private:
  void cut_chain(const RowRange& row, std::span<const Vec3> chain, size_t begin,
                 std::vector<ScanLine>& out) const {
    const double tolerance = settings_.line_tolerance_m > 0
                                 ? settings_.line_tolerance_m
                                 : settings_.surface.distance_tolerance_m;
    const std::vector<uint32_t> cuts = straight_cuts(chain, tolerance);
    for (size_t k = 0; k + 1 < cuts.size(); ++k) {
      if (cuts[k + 1] - cuts[k] + 1 < settings_.line_points) continue;
      ScanLine line;
      line.first = row.first + static_cast<uint32_t>(begin) + cuts[k];
      line.last = row.first + static_cast<uint32_t>(begin) + cuts[k + 1] + 1;
      line.row = places_[line.first].row;
      line.from = places_[line.first].along;
      line.to = places_[line.last - 1].along;
      line.moments.reference = reference_;
      for (uint32_t i = cuts[k]; i <= cuts[k + 1]; ++i) line.moments.add(chain[i]);
      out.push_back(line);
    }
  }

  const SegmentScene& scene_;
  std::span<const ScanPlace> places_;
  std::span<const uint32_t> positions_;
  const ScanLineSettings& settings_;
  Vec3 reference_;
};

}  // namespace

std::vector<uint32_t> straight_cuts(std::span<const Vec3> chain, double tolerance_m) {
  if (chain.size() < 2) return {};
  const auto last = static_cast<uint32_t>(chain.size() - 1);
  std::vector<uint32_t> cuts{0, last};
  std::vector<std::pair<uint32_t, uint32_t>> todo{{0, last}};
  while (!todo.empty()) {
    const auto [from, to] = todo.back();
    todo.pop_back();
    const Vec3 chord = normalized(chain[to] - chain[from]);
    double most = tolerance_m;
    uint32_t at = from;
    for (uint32_t i = from + 1; i < to; ++i) {
      const Vec3 d = chain[i] - chain[from];
      const double off = norm(d - dot(d, chord) * chord);
      if (off <= most) continue;
      most = off;
      at = i;
    }
    if (at == from) continue;
    cuts.push_back(at);
    todo.push_back({from, at});
    todo.push_back({at, to});
  }
  std::sort(cuts.begin(), cuts.end());
  return cuts;
}

std::vector<ScanLine> straight_pieces(const SegmentScene& scene, std::span<const ScanPlace> places,
                                      std::span<const uint32_t> positions,
                                      const ScanLineSettings& settings, Task& task) {
  const std::vector<RowRange> rows = rows_of(places);
  const RowCutter cutter(scene, places, positions, settings);
  std::vector<std::vector<ScanLine>> parts(rows.size());
  parallel_for(task, rows.size(), kScanRowsPerChunk, [&](size_t begin, size_t end) {
    for (size_t r = begin; r < end; ++r) cutter.cut(rows[r], parts[r]);
  });
  std::vector<ScanLine> lines;
  for (auto& part : parts) {
    lines.insert(lines.end(), part.begin(), part.end());
    part = {};
  }
  return lines;
}

}  // namespace jalon
