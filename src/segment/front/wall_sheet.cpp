// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/front/wall_sheet.h"

#include <algorithm>
#include <atomic>
#include <cmath>

#include "base/parallel.h"

namespace jalon {

namespace {

// Cells of about nine points: few of a measured wall are empty, even where it is half as dense.
constexpr double kCellSpacings = 3;
constexpr double kLeastCell_m = 0.04, kMostCell_m = 0.5;
constexpr double kMostCells = 1 << 22;
constexpr size_t kSheetPointsPerChunk = 1 << 15;
constexpr int kLeastAlike = 6;  // of the eight about a cell: edges belong to neither kind

struct SheetBox {
  double left = INFINITY, right = -INFINITY, foot = INFINITY, top = -INFINITY, points = 0;
  SheetBox& operator+=(const SheetBox& b) {
    left = std::min(left, b.left);
    right = std::max(right, b.right);
    foot = std::min(foot, b.foot);
    top = std::max(top, b.top);
    points += b.points;
    return *this;
  }
};

std::vector<uint8_t> membership(const WallGroup& group, size_t segments) {
  std::vector<uint8_t> out(segments + 1, 0);  // by label
  for (const size_t member : group.members) out[member + 1] = 1;
  return out;
}

}  // namespace

WallSheet::WallSheet(const Cloud& cloud, const Vec3& origin, std::span<const uint32_t> labels,
                     const std::vector<Segment>& segments, const WallGroup& group, Task& task)
    : plane_(segments[group.main].fit.plane) {
  along_ = normalized(cross({0, 0, 1}, plane_.normal));
  up_ = cross(plane_.normal, along_);
  // 1. Its box and the size of its cells.
  const std::vector<uint8_t> is_member = membership(group, segments.size());
  const auto for_members = [&](size_t begin, size_t end, auto&& take) {
    for (size_t i = begin; i < end; ++i)
      if (is_member[labels[i]] != 0) take(place_of(cloud.point(i) - origin));
  };
  const SheetBox box = parallel_reduce(
      task, cloud.size(), kSheetPointsPerChunk, SheetBox{}, [&](size_t begin, size_t end) {
        SheetBox b;
        for_members(begin, end, [&](const WallPlace& p) { b += SheetBox{p.u, p.u, p.v, p.v, 1}; });
        return b;
      });
  double area_m2 = 0;
  for (const size_t member : group.members) area_m2 += segments[member].area_m2;
  const double spacing = std::sqrt(area_m2 / box.points);
  const double width = box.right - box.left, height = box.top - box.foot;
  cell_m_ = std::max(std::clamp(kCellSpacings * spacing, kLeastCell_m, kMostCell_m),
                     std::sqrt(width * height / kMostCells));
  left_ = box.left;
  foot_ = box.foot;
  columns_ = static_cast<size_t>(width / cell_m_) + 1;
  rows_ = static_cast<size_t>(height / cell_m_) + 1;
  // 2. Which of them were measured.
  std::vector<uint8_t> is_measured(columns_ * rows_, 0);
  parallel_for(task, cloud.size(), kSheetPointsPerChunk, [&](size_t begin, size_t end) {
    for_members(begin, end, [&](const WallPlace& p) {
      std::atomic_ref<uint8_t>(is_measured[cell_of(p.u, p.v)]).store(1, std::memory_order_relaxed);
    });
  });
  // 3. What they are.
  tell_kinds(is_measured);
}

size_t WallSheet::cell_of(double u, double v) const {
  const double column = (u - left_) / cell_m_, row = (v - foot_) / cell_m_;  // cut off below
  if (!(column >= 0 && row >= 0 && column < static_cast<double>(columns_) &&
        row < static_cast<double>(rows_)))
    return cells();
  return static_cast<size_t>(row) * columns_ + static_cast<size_t>(column);
}

void WallSheet::tell_kinds(const std::vector<uint8_t>& is_measured) {
  kind_.assign(cells(), Kind::kOutside);
  // Within the wall: below the highest measured row of each column, between the first and the last column of each row.
  std::vector<size_t> top(columns_, 0);
  for (size_t r = 0; r < rows_; ++r)
    for (size_t c = 0; c < columns_; ++c)
      if (is_measured[r * columns_ + c] != 0) top[c] = r + 1;
  for (size_t r = 0; r < rows_; ++r) {
    const uint8_t* row = &is_measured[r * columns_];
    const auto first = static_cast<size_t>(std::find(row, row + columns_, 1) - row);
    size_t last = columns_;
    while (last > first && row[last - 1] == 0) --last;
    for (size_t c = first; c < last; ++c) {
      if (r >= top[c]) continue;
      int about = 0, measured = 0;
      for (size_t y = r == 0 ? 0 : r - 1; y <= std::min(rows_ - 1, r + 1); ++y)
        for (size_t x = c == 0 ? 0 : c - 1; x <= std::min(columns_ - 1, c + 1); ++x) {
          if (x == c && y == r) continue;
          ++about;
          measured += is_measured[y * columns_ + x];
        }
      const bool is_in = row[c] != 0;
      const int alike = is_in ? measured : about - measured;
      kind_[r * columns_ + c] = alike < std::min(about, kLeastAlike) ? Kind::kBorder
                                : is_in                              ? Kind::kSolid
                                                                     : Kind::kOpen;
    }
  }
}

}  // namespace jalon
