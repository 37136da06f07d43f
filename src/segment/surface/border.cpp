// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/surface/border.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"

namespace jalon {

namespace {

constexpr size_t kBorderPointsPerChunk = 1 << 12;
constexpr unsigned kBorderSectors = 8;
constexpr unsigned kEmptySideBySide = 3;
// Every so many-th of the points around is looked at first: most points lie within a surface, and as many close it.
constexpr uint32_t kGlance = 5;

unsigned sector_of(double u, double v) {
  const unsigned steep = std::fabs(v) > std::fabs(u) ? 1 : 0;
  if (u >= 0) return v >= 0 ? steep : 7 - steep;
  return v >= 0 ? 3 - steep : 4 + steep;
}

bool has_open_side(unsigned filled) {
  const unsigned twice = filled | filled << kBorderSectors;
  for (unsigned k = 0; k < kBorderSectors; ++k)
    if ((twice >> k & ((1u << kEmptySideBySide) - 1)) == 0) return true;
  return false;
}

/// Points sorted by the cells of a grid.
class Grid {
 public:
  Grid(std::span<const Vec2> points, double cell_m) {
    Vec2 low{INFINITY, INFINITY}, high{-INFINITY, -INFINITY};
    for (const Vec2& p : points) {
      low = {std::min(low.u, p.u), std::min(low.v, p.v)};
      high = {std::max(high.u, p.u), std::max(high.v, p.v)};
    }
    low_ = low;
    // Not more cells than points: a sparse surface gets larger ones.
    const double most = std::ceil(std::sqrt(4.0 * static_cast<double>(points.size())));
    cell_m_ = std::max({cell_m, (high.u - low.u) / most, (high.v - low.v) / most});
    columns_ = static_cast<size_t>((high.u - low.u) / cell_m_) + 1;
    rows_ = static_cast<size_t>((high.v - low.v) / cell_m_) + 1;
    starts_.assign(columns_ * rows_ + 1, 0);
    for (const Vec2& p : points) ++starts_[row(p.v) * columns_ + column(p.u) + 1];
    for (size_t c = 1; c < starts_.size(); ++c) starts_[c] += starts_[c - 1];
    sorted_.resize(points.size());
    std::vector<uint32_t> next(starts_.begin(), starts_.end() - 1);
    for (const Vec2& p : points) sorted_[next[row(p.v) * columns_ + column(p.u)]++] = p;
  }

  /// Every step-th of the points around, until f says that it knows enough.
  template <class F>
  void near(const Vec2& p, uint32_t step, F&& f) const {
    const size_t c = column(p.u), r = row(p.v);
    for (size_t j = r == 0 ? 0 : r - 1; j <= std::min(r + 1, rows_ - 1); ++j) {
      const size_t first = j * columns_ + (c == 0 ? 0 : c - 1),
                   last = j * columns_ + std::min(c + 1, columns_ - 1);
      for (uint32_t i = starts_[first]; i < starts_[last + 1]; i += step)
        if (f(sorted_[i])) return;
    }
  }

 private:
  size_t column(double u) const {
    return std::min(columns_ - 1, static_cast<size_t>((u - low_.u) / cell_m_));
  }
  size_t row(double v) const {
    return std::min(rows_ - 1, static_cast<size_t>((v - low_.v) / cell_m_));
  }
  Vec2 low_;
  double cell_m_ = 0;
  size_t columns_ = 0, rows_ = 0;
  std::vector<uint32_t> starts_;
  std::vector<Vec2> sorted_;
};

}  // namespace

std::vector<uint8_t> border_points(std::span<const Vec2> points, double margin_m, double reach_m,
                                   Task& task) {
  std::vector<uint8_t> out(points.size(), 0);
  if (points.empty()) return out;
  const Grid grid(points, reach_m);
  const double near2 = margin_m * margin_m, far2 = reach_m * reach_m;
  parallel_for(task, points.size(), kBorderPointsPerChunk, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      unsigned filled = 0;
      bool open = true;
      const auto look_at = [&](const Vec2& q) {
        const double u = q.u - points[i].u, v = q.v - points[i].v, d2 = u * u + v * v;
        if (!(d2 > near2 && d2 <= far2)) return false;
        const unsigned with = filled | 1u << sector_of(u, v);
        if (with == filled) return false;
        filled = with;
        return !(open = has_open_side(filled));
      };
      grid.near(points[i], kGlance, look_at);
      if (open) grid.near(points[i], 1, look_at);
      out[i] = open;
    }
  });
  return out;
}

}  // namespace jalon
