// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/plane/point_block.h"

#include <cmath>

namespace jalon {

namespace {

// Of rounding: the box's own numbers differ from those of its points by some units in the last place.
constexpr double kRounding_m = 1e-6;

struct Range {
  double low, high;
};
// Of d . axis over all d about the middle within the half sides.
Range along(const Vec3& middle, const Vec3& half, const Vec3& axis) {
  const double at = dot(middle, axis);
  const double reach = std::fabs(half.x * axis.x) + std::fabs(half.y * axis.y) +
                       std::fabs(half.z * axis.z) + kRounding_m;
  return {at - reach, at + reach};
}

}  // namespace

void PointBlock::fill(const Cloud& cloud, std::span<const uint32_t> order, size_t begin,
                      size_t count) {
  count_ = count;
  box_ = {};
  for (size_t k = 0; k < count; ++k) {
    index_[k] = order.empty() ? static_cast<uint32_t>(begin + k) : order[begin + k];
    const Vec3 p = cloud.point(index_[k]);
    box_.add(p);
    x_[k] = p.x;
    y_[k] = p.y;
    z_[k] = p.z;
  }
  // The loops below run over whole blocks: what lies behind the last point is of no meaning, yet a number.
  for (size_t k = count; k < kMost; ++k) x_[k] = y_[k] = z_[k] = 0;
}

void PointBlock::heights(const PlaneFrame& frame, double* height) const {
  const Vec3 o = frame.origin, n = frame.normal;
  const double above = frame.height;
  for (size_t k = 0; k < kMost; ++k)
    height[k] = (x_[k] - o.x) * n.x + (y_[k] - o.y) * n.y + (z_[k] - o.z) * n.z - above;
}

void PointBlock::project(const PlaneFrame& frame, double* u, double* v) const {
  const Vec3 o = frame.origin, a = frame.axis_u, b = frame.axis_v;
  for (size_t k = 0; k < kMost; ++k) {
    const double x = x_[k] - o.x, y = y_[k] - o.y, z = z_[k] - o.z;
    u[k] = x * a.x + y * a.y + z * a.z;
    v[k] = x * b.x + y * b.y + z * b.z;
  }
}

FrameBox PointBlock::bounds(const PlaneFrame& frame) const {
  const Vec3 middle = (box_.min + box_.max) * 0.5 - frame.origin;
  const Vec3 half = (box_.max - box_.min) * 0.5;
  const Range u = along(middle, half, frame.axis_u), v = along(middle, half, frame.axis_v),
              w = along(middle, half, frame.normal);
  return {{u.low, v.low}, {u.high, v.high}, w.low - frame.height, w.high - frame.height};
}

}  // namespace jalon
