// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/preview/cell_planes.h"

#include <cmath>

#include "base/numbers.h"
#include "geometry/symmetric_eigen.h"

namespace jalon {

namespace {

constexpr int kGridBits = 31, kCellBits = 14;
// As in fit_plane: below this share of the largest eigenvalue the second one is rounding; here of 2^-14.
constexpr double kCollinear = 1e-7;

// Whole numbers add up to the same whatever the order, so the loop may run in lanes.
struct Sums {
  int64_t x = 0, y = 0, z = 0, xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0;
};

Sums sums_of(const Octree& tree, int level, size_t first, size_t count) {
  // Inside the cell, about its centre: 14 bits and a sign, so that products fit 32.
  const int cell_bits = kGridBits - level;
  const int down = cell_bits > kCellBits ? cell_bits - kCellBits : 0;
  const int32_t mask = static_cast<int32_t>((int64_t{1} << cell_bits) - 1),
                half = (mask >> down) / 2;
  const int32_t *xs = tree.grid_x() + first, *ys = tree.grid_y() + first,
                *zs = tree.grid_z() + first;
  Sums s;
  for (size_t i = 0; i < count; ++i) {
    const int32_t x = ((xs[i] & mask) >> down) - half, y = ((ys[i] & mask) >> down) - half,
                  z = ((zs[i] & mask) >> down) - half;
    s.x += x, s.y += y, s.z += z;
    s.xx += x * x, s.xy += x * y, s.xz += x * z, s.yy += y * y, s.yz += y * z, s.zz += z * z;
  }
  return s;
}

bool normal_of(const Octree& tree, int level, size_t first, size_t count, Vec3& normal) {
  if (count < 3) return false;
  const Sums s = sums_of(tree, level, first, count);
  const auto n = static_cast<double>(count), x = static_cast<double>(s.x),
             y = static_cast<double>(s.y), z = static_cast<double>(s.z);
  const Eigen3 eigen = symmetric_eigen(
      {static_cast<double>(s.xx) - x * x / n, static_cast<double>(s.xy) - x * y / n,
       static_cast<double>(s.xz) - x * z / n, static_cast<double>(s.yy) - y * y / n,
       static_cast<double>(s.yz) - y * z / n, static_cast<double>(s.zz) - z * z / n});
  normal = eigen.vectors[0];
  return eigen.values[1] > kCollinear * eigen.values[2];
}

}  // namespace

double plane_angle(const Octree& reference, const Octree& compared, int level,
                   const CellPair& pair) {
  Vec3 a, b;
  if (!normal_of(reference, level, pair.reference_first, pair.reference_count, a) ||
      !normal_of(compared, level, pair.compared_first, pair.compared_count, b))
    return kNaN;
  return std::atan2(norm(cross(a, b)), std::fabs(dot(a, b)));
}

}  // namespace jalon
