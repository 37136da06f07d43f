// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "spatial/neighbours/shape_search.h"

#include <algorithm>
#include <cmath>

#include "base/simd.h"
#include "spatial/neighbours/shape_kernel.h"
#include "spatial/octree/exact_walk.h"
#include "spatial/octree/impl.h"

namespace jalon {

namespace {

constexpr size_t kFirstCapacity = 1024;

// How much wider than asked for, in radii.
constexpr double kMargin = 1.0;

// A grid coordinate stands for [g, g + 1): the point is within half a diagonal, sqrt(3) / 2, of the cell's middle.
constexpr double kShapeSearchGridError = 1;

// A float above the limit by its rounding and by that of the kernel's sums of lengths up to reach.
float widened(double limit, double reach) {
  constexpr double kRounding = 0x1p-20;
  return static_cast<float>(limit + kShapeSearchGridError + kRounding * (limit + reach));
}

}  // namespace

ShapeSearch::ShapeSearch(const Octree& tree) : tree_(tree), avx2_(use_avx2()) {}

GridShape ShapeSearch::grid_shape(const Shape& shape) const {
  const Octree::Impl& tree = tree_.impl();
  GridShape out{};
  const Vec3 grid = (shape.centre - tree.cube.origin) * tree.inverse_step;
  constexpr double kLast = 2147483647.0;
  for (int c = 0; c < 3; ++c) {
    const double base = std::clamp(std::floor(grid[c]), 0.0, kLast);
    out.base[c] = static_cast<int32_t>(base);
    out.offset[c] = static_cast<float>(grid[c] - 0.5 - base);
    out.axis[c] = static_cast<float>(shape.axis[c]);
  }
  const double radius = shape.radius_m * tree.inverse_step,
               half_length = shape.half_length_m * tree.inverse_step;
  out.radius = widened(radius, radius + half_length);
  out.half_length = widened(half_length, radius + half_length);
  out.is_ball = shape.is_ball;
  return out;
}

// Is all of a shape within the wide one? For a cylinder: are the discs at its ends?
bool ShapeSearch::covers(const Shape& wide, const Shape& shape) {
  if (wide.is_ball != shape.is_ball) return false;
  const double room = (wide.radius_m - shape.radius_m) * (1 - 1e-9);
  if (!(room >= 0)) return false;
  const Vec3 apart = shape.centre - wide.centre;
  if (shape.is_ball) return squared_norm(apart) <= room * room;
  for (const double end_m : {-shape.half_length_m, shape.half_length_m}) {
    const Vec3 end = apart + end_m * shape.axis;
    const double along = dot(end, wide.axis);
    if (squared_norm(end - along * wide.axis) > room * room) return false;
    if (std::fabs(along) + shape.radius_m > wide.half_length_m) return false;
  }
  return true;
}

// Takes the points of a shape wide enough for searches around this one.
void ShapeSearch::take(const Shape& shape) {
  wide_ = shape;
  const double margin_m = kMargin * shape.radius_m;
  wide_.radius_m += margin_m;
  if (!shape.is_ball) wide_.half_length_m += shape.radius_m + margin_m;
  const GridShape grid = grid_shape(wide_);
  const auto kernel = avx2_ ? gather_shape_avx2 : gather_shape_baseline;
  for (;;) {
    const size_t capacity = std::max(positions_.size(), kFirstCapacity);
    coordinates_.resize(3 * capacity);
    positions_.resize(capacity);
    candidates_.resize(capacity);
    points_ = {coordinates_.data(),
               coordinates_.data() + capacity,
               coordinates_.data() + 2 * capacity,
               positions_.data(),
               capacity,
               0};
    if (kernel(tree_.impl().view, grid, points_)) break;
    positions_.resize(2 * capacity);
  }
  taken_ = true;
}

namespace {

// Does a box in doubles perhaps meet the shape? A cylinder: is the ball around the box within its reach along and
// beside the axis?
template <class Shape>
bool may_meet(const Shape& shape, const ExactBlock& block, size_t slot) {
  if (shape.is_ball)
    return squared_distance(block, slot, shape.centre) <= shape.radius_m * shape.radius_m;
  Vec3 middle, half;
  for (int c = 0; c < 3; ++c) {
    middle[c] = 0.5 * (block.lo[c][slot] + block.hi[c][slot]) - shape.centre[c];
    half[c] = 0.5 * (block.hi[c][slot] - block.lo[c][slot]);
  }
  constexpr double kRoom = 1 + 1e-12;  // for the rounding of these few sums
  const double along = dot(middle, shape.axis), reach = norm(half) + 1e-12 * norm(middle);
  return std::fabs(along) <= (shape.half_length_m + reach) * kRoom &&
         norm(middle - along * shape.axis) <= (shape.radius_m + reach) * kRoom;
}

}  // namespace

// The same for shapes of a few steps in a tree whose grid does not tell its points apart.
size_t ShapeSearch::search_exactly(const Shape& shape) {
  const Octree::Impl& tree = tree_.impl();
  candidates_.clear();
  exact_runs(
      tree, [&](const ExactBlock& block, size_t slot) { return may_meet(shape, block, slot); },
      [&](size_t first, size_t last) {
        for (size_t i = first; i < last; ++i) candidates_.push_back(static_cast<uint32_t>(i));
      });
  taken_ = false;  // candidates_ has another size
  return candidates_.size();
}

// The positions of all points of the shape, and few others, to candidates_.
size_t ShapeSearch::search(const Shape& shape) {
  const Octree::Impl& tree = tree_.impl();
  if (tree.count == 0) return 0;
  if (tree.has_exact_boxes() && shape.radius_m * tree.inverse_step < kFewSteps)
    return search_exactly(shape);
  if (!taken_ || !covers(wide_, shape)) take(shape);
  const auto kernel = avx2_ ? filter_shape_avx2 : filter_shape_baseline;
  return kernel(points_, grid_shape(shape), candidates_.data());
}

std::span<const Vec3> ShapeSearch::ball(const Vec3& centre, double radius_m) {
  const Octree::Impl& tree = tree_.impl();
  const size_t candidates = search({centre, {}, radius_m, 0, true});
  const double squared_radius = radius_m * radius_m;
  uint32_t* position = candidates_.data();
  offsets_.resize(candidates);
  size_t count = 0;
  for (size_t i = 0; i < candidates; ++i) {
    const Vec3 d = tree.exact_point(position[i]) - centre;
    offsets_[count] = d;
    position[count] = position[i];
    count += squared_norm(d) <= squared_radius;
  }
  offsets_.resize(count);
  return offsets_;
}

std::span<const ShapeSearch::Along> ShapeSearch::cylinder(const Vec3& centre, const Vec3& axis,
                                                          double radius_m, double half_length_m) {
  const Octree::Impl& tree = tree_.impl();
  const size_t candidates = search({centre, axis, radius_m, half_length_m, false});
  const double squared_radius = radius_m * radius_m;
  along_.resize(candidates);
  size_t count = 0;
  for (size_t i = 0; i < candidates; ++i) {
    const Vec3 d = tree.exact_point(candidates_[i]) - centre;
    const double along = dot(d, axis);
    along_[count] = {along, candidates_[i]};
    count += std::fabs(along) <= half_length_m && squared_norm(d - along * axis) <= squared_radius;
  }
  along_.resize(count);
  return along_;
}

namespace {

// A box in doubles as a cylinder sees it.
struct BoxAlong {
  double along_m, reach_m;  // of its middle; half of its length along the axis
  double beside_m;          // no point of it is farther from the axis
};
BoxAlong box_along(const ExactBlock& block, size_t slot, const Vec3& centre, const Vec3& axis) {
  Vec3 middle, half;
  double reach_m = 0;
  for (int c = 0; c < 3; ++c) {
    middle[c] = 0.5 * (block.lo[c][slot] + block.hi[c][slot]) - centre[c];
    half[c] = 0.5 * (block.hi[c][slot] - block.lo[c][slot]);
    reach_m += std::fabs(axis[c]) * half[c];
  }
  const double along = dot(middle, axis);
  return {along, reach_m, norm(middle - along * axis) + norm(half)};
}

}  // namespace

std::span<const ShapeSearch::AlongRun> ShapeSearch::cylinder_runs(const Vec3& centre,
                                                                  const Vec3& axis, double radius_m,
                                                                  double half_length_m) {
  // Some hundred roundings of the cylinder's size: less than what tells points apart along it, and surely inside.
  constexpr double kRoundings = 0x1p-44;
  const double flat_m = kRoundings * (radius_m + half_length_m),
               squared_radius = radius_m * radius_m;
  const Octree::Impl& tree = tree_.impl();
  const Shape shape{centre, axis, radius_m, half_length_m, false};
  runs_.clear();
  const auto look_at = [&](size_t first, size_t last) {
    looked_at_ += last - first;
    for (size_t i = first; i < last; ++i) {
      const Vec3 d = tree.exact_point(i) - centre;
      const double along = dot(d, axis);
      if (std::fabs(along) <= half_length_m && squared_norm(d - along * axis) <= squared_radius)
        runs_.push_back({along, 1});
    }
  };
  const auto descend = [&](const auto& self, size_t level, size_t number) -> void {
    const ExactBlock& block = tree.exact_levels[level][number];
    for (size_t slot = 0; slot < kBoxes; ++slot) {
      if (block.least_index[slot] == kNoPoint) continue;
      ++looked_at_;
      if (!may_meet(shape, block, slot)) continue;
      const size_t child = number * kBoxes + slot;
      const BoxAlong box = box_along(block, slot, centre, axis);
      if (2 * box.reach_m <= flat_m &&
          std::fabs(box.along_m) + box.reach_m + flat_m <= half_length_m &&
          box.beside_m + flat_m <= radius_m) {
        const size_t points = kExactRun << 3 * level,
                     first = child * points;  // eight boxes a level
        runs_.push_back(
            {box.along_m, static_cast<uint32_t>(std::min(tree.count, first + points) - first)});
      } else if (level > 0) {
        self(self, level - 1, child);
      } else {
        scan_run(tree, child, look_at);
      }
    }
  };
  if (tree.count != 0) descend(descend, tree.exact_levels.size() - 1, 0);
  return runs_;
}

}  // namespace jalon
