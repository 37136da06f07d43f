// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "spatial/neighbours/ball_ranges.h"

#include <algorithm>
#include <cmath>

namespace jalon {

namespace {

// A box in the caller's coordinates.
struct Bounds {
  Vec3 lo, hi;
};

bool is_used(const ExactBlock& block, size_t slot) { return block.least_index[slot] != kNoPoint; }
bool is_used(const BoxBlock& block, size_t slot) { return block.lo[0][slot] <= block.hi[0][slot]; }

Bounds bounds_of(const Octree::Impl&, const ExactBlock& block, size_t slot, double) {
  return {{block.lo[0][slot], block.lo[1][slot], block.lo[2][slot]},
          {block.hi[0][slot], block.hi[1][slot], block.hi[2][slot]}};
}
// A coordinate on the grid stands for one step.
Bounds bounds_of(const Octree::Impl& tree, const BoxBlock& block, size_t slot, double slack_m) {
  Bounds out;
  for (int axis = 0; axis < 3; ++axis) {
    out.lo[axis] = tree.cube.origin[axis] + block.lo[axis][slot] * tree.step - slack_m;
    out.hi[axis] = tree.cube.origin[axis] + (block.hi[axis][slot] + 1.0) * tree.step + slack_m;
  }
  return out;
}

enum class Lies { kOutside, kAcross, kInside };

// The same rounding as of the points' own distances, and each step of it rises with its operands: what is inside here
// is inside there.
Lies place_of(const Bounds& box, const Vec3& centre, double squared_m2) {
  Vec3 near, far;
  for (int axis = 0; axis < 3; ++axis) {
    const double below = box.lo[axis] - centre[axis], above = box.hi[axis] - centre[axis];
    near[axis] = std::max({below, -above, 0.0});
    far[axis] = std::max(std::abs(below), std::abs(above));
  }
  if (squared_norm(far) <= squared_m2) return Lies::kInside;
  return squared_norm(near) <= squared_m2 ? Lies::kAcross : Lies::kOutside;
}

}  // namespace

BallRanges::BallRanges(const Octree::Impl& tree, double radius_m)
    : tree_(tree), squared_m2_(radius_m >= 0 ? radius_m * radius_m : -1) {
  double most = tree.cube.edge;
  for (int axis = 0; axis < 3; ++axis) most = std::max(most, std::abs(tree.cube.origin[axis]));
  slack_m_ = 0x1p-48 * most;  // more than the rounding on the way to the grid and back
}

std::span<const BallRanges::Range> BallRanges::find(const Vec3& centre) {
  ranges_.clear();
  points_ = 0;
  if (tree_.count == 0) return {};
  if (tree_.has_exact_boxes()) {
    descend(tree_.exact_levels, centre,
            [&](size_t run) { return std::min(tree_.count, run * kExactRun); });
  } else {
    descend(tree_.levels, centre,
            [&](size_t leaf) -> size_t { return tree_.leaf_first[std::min(tree_.leaves, leaf)]; });
  }
  return ranges_;
}

// first_of(box of the lowest level): its first position.
template <class Levels, class FirstOf>
void BallRanges::descend(const Levels& levels, const Vec3& centre, FirstOf first_of) {
  const auto enter = [&](const auto& self, size_t level, size_t number) -> void {
    const auto& block = levels[level][number];
    for (size_t slot = 0; slot < kBoxes; ++slot) {
      if (!is_used(block, slot)) continue;
      ++looked_at_;
      const Lies lies = place_of(bounds_of(tree_, block, slot, slack_m_), centre, squared_m2_);
      if (lies == Lies::kOutside) continue;
      const size_t child = number * kBoxes + slot;
      if (lies == Lies::kAcross && level > 0) {
        self(self, level - 1, child);
        continue;
      }
      const size_t first = first_of(child << 3 * level),
                   last = first_of((child + 1) << 3 * level);  // eight boxes a level
      if (lies == Lies::kInside) take(first, last);
      else scan(centre, first, last);
    }
  };
  enter(enter, levels.size() - 1, 0);
}

void BallRanges::take(size_t first, size_t last) {
  points_ += last - first;
  if (!ranges_.empty() && ranges_.back().last == first)
    ranges_.back().last = static_cast<uint32_t>(last);
  else ranges_.push_back({static_cast<uint32_t>(first), static_cast<uint32_t>(last)});
}

void BallRanges::scan(const Vec3& centre, size_t first, size_t last) {
  looked_at_ += last - first;
  size_t begin = first;  // of those inside that follow one another
  for (size_t i = first; i < last; ++i) {
    if (squared_norm(tree_.exact_point(i) - centre) <= squared_m2_) continue;
    if (begin < i) take(begin, i);
    begin = i + 1;
  }
  if (begin < last) take(begin, last);
}

}  // namespace jalon
