// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/surface/border.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/parallel.h"

namespace jalon {

namespace {

constexpr size_t kBorderPointsPerChunk = 1 << 12;
constexpr unsigned kBorderSectors = 8;
constexpr unsigned kEmptySideBySide = 3;
// Every so many-th of the points around is looked at first: most points lie within a surface, and as many close it.
constexpr uint32_t kGlance = 5;

// The sector of a direction by what is negative and what is steep, as a bit; whoever looks at many directions cannot
// foresee these, and a branch for each would be guessed wrong every other time.
constexpr std::array<uint8_t, 8> kSectorBits = [] {
  std::array<uint8_t, 8> bits{};
  for (unsigned steep = 0; steep < 2; ++steep) {
    const unsigned sectors[] = {steep, 3 - steep, 7 - steep, 4 + steep};
    for (unsigned signs = 0; signs < 4; ++signs)
      bits[2 * signs + steep] = static_cast<uint8_t>(1u << sectors[signs]);
  }
  return bits;
}();

unsigned sector_bit(double u, double v) {
  const auto left = static_cast<unsigned>(u < 0), below = static_cast<unsigned>(v < 0);
  const auto steep = static_cast<unsigned>(std::fabs(v) > std::fabs(u));
  return kSectorBits[4 * below + 2 * left + steep];
}

// By filled sectors, a bit each.
constexpr size_t kSectorSets = size_t{1} << kBorderSectors;
constexpr std::array<bool, kSectorSets> kHasOpenSide = [] {
  std::array<bool, kSectorSets> open{};
  for (unsigned filled = 0; filled < kSectorSets; ++filled) {
    const unsigned twice = filled | filled << kBorderSectors;
    for (unsigned k = 0; k < kBorderSectors; ++k)
      open[filled] = open[filled] || (twice >> k & ((1u << kEmptySideBySide) - 1)) == 0;
  }
  return open;
}();

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
      const auto look_at = [&](const Vec2& q) {
        const double u = q.u - points[i].u, v = q.v - points[i].v, d2 = u * u + v * v;
        const unsigned in_ring =
            static_cast<unsigned>(d2 > near2) & static_cast<unsigned>(d2 <= far2);
        filled |= sector_bit(u, v) & (0u - in_ring);
        return !kHasOpenSide[filled];
      };
      grid.near(points[i], kGlance, look_at);
      if (kHasOpenSide[filled]) grid.near(points[i], 1, look_at);
      out[i] = kHasOpenSide[filled];
    }
  });
  return out;
}

}  // namespace jalon
