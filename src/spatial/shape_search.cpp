// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "spatial/shape_search.h"

#include <algorithm>
#include <cmath>

#include "base/simd.h"
#include "spatial/octree_impl.h"
#include "spatial/shape_kernel.h"

namespace jalon {

namespace {

constexpr size_t kFirstCapacity = 1024;

// A grid coordinate stands for [g, g + 1): the point is within half a diagonal, sqrt(3) / 2, of the cell's middle.
constexpr double kGridError = 1;

// A float above the limit by its rounding and by that of the kernel's sums of lengths up to reach.
float widened(double limit, double reach) {
  constexpr double kRounding = 0x1p-20;
  return static_cast<float>(limit + kGridError + kRounding * (limit + reach));
}

GridShape grid_shape(const Octree::Impl& tree, const Vec3& centre, const Vec3* axis, double radius_m,
                     double half_length_m) {
  GridShape shape{};
  const Vec3 grid = (centre - tree.cube.origin) * tree.inverse_step;
  constexpr double kLast = 2147483647.0;
  for (int c = 0; c < 3; ++c) {
    const double base = std::clamp(std::floor(grid[c]), 0.0, kLast);
    shape.base[c] = static_cast<int32_t>(base);
    shape.offset[c] = static_cast<float>(grid[c] - 0.5 - base);
    shape.axis[c] = axis != nullptr ? static_cast<float>((*axis)[c]) : 0.0f;
  }
  const double radius = radius_m * tree.inverse_step, half_length = half_length_m * tree.inverse_step;
  const double reach = axis != nullptr ? radius + half_length : radius;
  shape.radius = widened(radius, reach);
  shape.half_length = widened(half_length, reach);
  shape.is_ball = axis == nullptr;
  return shape;
}

}  // namespace

ShapeSearch::ShapeSearch(const Octree& tree)
    : tree_(tree),
      avx2_(use_avx2()),
      capacity_(kFirstCapacity),
      candidates_(std::make_unique<uint32_t[]>(kFirstCapacity)) {}

size_t ShapeSearch::gather(const Vec3& centre, const Vec3* axis, double radius_m, double half_length_m) {
  const Octree::Impl& tree = tree_.impl();
  if (tree.count == 0) return 0;
  const GridShape shape = grid_shape(tree, centre, axis, radius_m, half_length_m);
  const auto kernel = avx2_ ? gather_shape_avx2 : gather_shape_baseline;
  size_t count = 0;
  while (!kernel(tree.view, shape, candidates_.get(), capacity_, count)) {
    capacity_ *= 2;
    candidates_ = std::make_unique<uint32_t[]>(capacity_);
  }
  return count;
}

std::span<const Vec3> ShapeSearch::ball(const Vec3& centre, double radius_m) {
  const Octree::Impl& tree = tree_.impl();
  const size_t candidates = gather(centre, nullptr, radius_m, 0);
  const double squared_radius = radius_m * radius_m;
  uint32_t* position = candidates_.get();
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

std::span<const ShapeSearch::Along> ShapeSearch::cylinder(const Vec3& centre, const Vec3& axis, double radius_m,
                                                          double half_length_m) {
  const Octree::Impl& tree = tree_.impl();
  const size_t candidates = gather(centre, &axis, radius_m, half_length_m);
  const double squared_radius = radius_m * radius_m;
  const uint32_t* position = candidates_.get();
  along_.resize(candidates);
  size_t count = 0;
  for (size_t i = 0; i < candidates; ++i) {
    const Vec3 d = tree.exact_point(position[i]) - centre;
    const double along = dot(d, axis);
    along_[count] = {along, position[i]};
    count += std::fabs(along) <= half_length_m && squared_norm(d - along * axis) <= squared_radius;
  }
  along_.resize(count);
  return along_;
}

}  // namespace jalon
