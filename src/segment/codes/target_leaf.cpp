// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/codes/target_leaf.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace jalon {

namespace {

constexpr double kLeafCell_m = 0.025;
constexpr double kDepthStep_m = 0.005;
constexpr int kFarthestBefore = 8,
              kFarthestBehind = 2;                     // steps: targets stick on panes 2 cm behind
constexpr double kNarrowest_m = 0.5, kLowest_m = 1.5;  // doors
constexpr double kDeepestPanel_m = 0.04;  // behind the front: panes and panels are the leaf's
// A leaf's rails stand at its front above or below whatever pane or panel, a frame's 8 cm of 2 m each; the troughs of a
// sheet nowhere reach its crests.
constexpr double kLeastOfRails = 0.02;
// Of a leaf's width; sheets with a pitch of 7.6 to 30 cm show their crests in 0.8 of it at most.
constexpr double kLeastFlat = 0.85;
constexpr int kLeafRounds = 2;

// Cells of one column: points at the front less those that contradict it, those at it, and those as little behind it
// as panes, panels and the troughs of a sheet.
struct CellVotes {
  double votes = 0, at_front = 0, behind = 0;
  CellVotes& operator+=(const CellVotes& b) {
    votes += b.votes, at_front += b.at_front, behind += b.behind;
    return *this;
  }
  bool shows_front() const { return at_front > kLeastOfRails * (at_front + behind); }
  // What lies behind speaks against a leaf where nothing stands at its front.
  double of_column() const { return shows_front() ? votes : votes - behind; }
};

// Cells of the plane about the target: points at a front less those before or behind it.
class Votes {
 public:
  Votes(std::span<const Vec3> points, const Vec2& target, double radius_m)
      : points_(points),
        target_(target),
        reach_(static_cast<size_t>(std::ceil(radius_m / kLeafCell_m))),
        side_(2 * reach_ + 1),
        cells_(side_ * side_) {}

  // The rectangle about the middle cell with the largest sum; its sum.
  double best(const OpeningFront& front, TargetLeaf& leaf) {
    count(front);
    double most = 0;
    std::vector<CellVotes> cells(side_);
    std::vector<double> column(side_);
    for (size_t low = 0; low <= reach_; ++low) {
      for (size_t s = 0; s < side_; ++s) cells[s] = sum(s, low, reach_);
      for (size_t high = reach_; high < side_; ++high) {
        for (size_t s = 0; s < side_; ++s) {
          if (high > reach_) cells[s] += cells_[high * side_ + s];
          column[s] = cells[s].of_column();
        }
        const auto [left, to_left] = farthest(column, -1);
        const auto [right, to_right] = farthest(column, 1);
        const double all = to_left + to_right - column[reach_];
        if (all <= most) continue;
        most = all;
        leaf = {front, edge(left) + target_.u, edge(right + 1) + target_.u, edge(low) + target_.v,
                edge(high + 1) + target_.v};
      }
    }
    return most;
  }

  // Whether the front is seen all over the width of a leaf.
  bool is_flat(const TargetLeaf& leaf) const {
    const size_t left = cell_of(leaf.left_m + kLeafCell_m / 2 - target_.u),
                 right = cell_of(leaf.right_m - kLeafCell_m / 2 - target_.u),
                 low = cell_of(leaf.low_m + kLeafCell_m / 2 - target_.v),
                 high = cell_of(leaf.high_m - kLeafCell_m / 2 - target_.v);
    size_t flat = 0;
    for (size_t s = left; s <= right; ++s) flat += sum(s, low, high).shows_front();
    return static_cast<double>(flat) >= kLeastFlat * static_cast<double>(right + 1 - left);
  }

 private:
  double edge(size_t cell) const {
    return (static_cast<double>(cell) - static_cast<double>(reach_) - 0.5) * kLeafCell_m;
  }
  size_t cell_of(double at) const {
    const double k = std::floor(at / kLeafCell_m + 0.5) + static_cast<double>(reach_);
    return k >= 0 && k < static_cast<double>(side_) ? static_cast<size_t>(k) : side_;
  }
  CellVotes sum(size_t s, size_t from, size_t to) const {
    CellVotes total;
    for (size_t z = from; z <= to; ++z) total += cells_[z * side_ + s];
    return total;
  }

  void count(const OpeningFront& front) {
    std::fill(cells_.begin(), cells_.end(), CellVotes{});
    std::vector<double> all(cells_.size(), 0.0);
    for (const Vec3& p : points_) {
      const size_t s = cell_of(p.x - target_.u), z = cell_of(p.z - target_.v);
      if (s == side_ || z == side_) continue;
      CellVotes& cell = cells_[z * side_ + s];
      const double before = p.y - front.before(p.x);
      if (std::fabs(before) < kLeafNoise_m) cell += {1, 1, 0};
      else if (before > 0 || before < -kDeepestPanel_m) cell.votes -= 1;
      else cell.behind += 1;
      ++all[z * side_ + s];
    }
    // A target is scanned densely and is but a few cells.
    std::vector<double> counts;
    for (const double n : all)
      if (n > 0) counts.push_back(n);
    if (counts.empty()) return;
    const auto middle = counts.begin() + static_cast<std::ptrdiff_t>(counts.size() / 2);
    std::nth_element(counts.begin(), middle, counts.end());
    for (CellVotes& cell : cells_)
      cell = {std::clamp(cell.votes, -*middle, *middle), std::min(cell.at_front, *middle),
              std::min(cell.behind, *middle)};
  }

  // From the middle column outward: where the sum is largest, and that sum.
  std::pair<size_t, double> farthest(const std::vector<double>& column, int step) const {
    size_t best = reach_;
    double sum = column[reach_], most = sum;
    for (size_t k = 1; k <= reach_; ++k) {
      const size_t at = step > 0 ? reach_ + k : reach_ - k;
      sum += column[at];
      if (sum > most) {
        most = sum;
        best = at;
      }
    }
    return {best, most};
  }

  std::span<const Vec3> points_;
  Vec2 target_;
  size_t reach_, side_;
  std::vector<CellVotes> cells_;  // rows of height
};

}  // namespace

bool find_leaf(std::span<const Vec3> points, const Vec2& target, double radius_m,
               TargetLeaf& leaf) {
  Votes votes(points, target, radius_m);
  double most = 0;
  for (int step = -kFarthestBehind; step <= kFarthestBefore; ++step) {
    TargetLeaf at_depth;
    const double sum = votes.best({step * kDepthStep_m, 0}, at_depth);
    if (sum <= most) continue;
    most = sum;
    leaf = at_depth;
  }
  if (most <= 0) return false;
  for (int round = 0; round < kLeafRounds; ++round) {
    std::vector<Vec3> within;
    for (const Vec3& p : points)
      if (leaf.holds(p.x, p.z)) within.push_back(p);
    OpeningFront front;
    if (!find_opening_front(within, front) || votes.best(front, leaf) <= 0) return false;
  }
  const double width = leaf.right_m - leaf.left_m;
  return width >= kNarrowest_m && leaf.high_m - leaf.low_m >= kLowest_m &&
         width < 2 * radius_m - 2 * kLeafCell_m && votes.is_flat(leaf);
}

}  // namespace jalon
