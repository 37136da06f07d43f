// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>

#include "cloud/plane_lanes.h"
#include "spatial/power_sums.h"
#include "geometry/symmetric_eigen.h"
#include "spatial/octree/octree.h"

namespace jalon {

/// The least-squares plane through the neighbours of a point.
struct NeighbourPlane {
  size_t position;            ///< of the point, in the tree's order
  const double* normal;       ///< null when the neighbours do not span a plane
  double variation;           ///< lambda_0 / (lambda_0 + lambda_1 + lambda_2)
  double squared_offset;      ///< of the neighbours' centroid from the point, grid steps^2
  Vec3 offset;                ///< the centroid itself, grid steps from the point
  const Symmetric3* scatter;  ///< sums of products about the centroid, grid steps^2
  size_t count;               ///< of the neighbours
};

/// Sums over neighbours of grid coordinates relative to the point, and of their products.
struct NeighbourSums {
  size_t count = 0;
  Vec3 sum;
  Symmetric3 products{};
};

/// Takes neighbourhoods one after the other and hands their planes on, four at a time.
template <class Write>
class NeighbourPlanes {
 public:
  NeighbourPlanes(const Octree& tree, Write write)
      : x_(tree.grid_x()), y_(tree.grid_y()), z_(tree.grid_z()), write_(std::move(write)) {}
  NeighbourPlanes(const NeighbourPlanes&) = delete;
  NeighbourPlanes& operator=(const NeighbourPlanes&) = delete;

  /// The neighbours of the point at a sorted position. Grid coordinates relative to the point are exact, so the sums
  /// are the same wherever the cloud lies.
  void add(size_t centre, const uint32_t* neighbours, size_t count) {
    add(centre, sums_of(centre, neighbours, count));
  }
  NeighbourSums sums_of(size_t centre, const uint32_t* neighbours, size_t count) const {
    double sx = 0, sy = 0, sz = 0, xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0;
    const int32_t cx = x_[centre], cy = y_[centre], cz = z_[centre];
    for (size_t j = 0; j < count; ++j) {
      const uint32_t i = neighbours[j];
      const double dx = x_[i] - cx, dy = y_[i] - cy, dz = z_[i] - cz;
      sx += dx, sy += dy, sz += dz;
      xx += dx * dx, xy += dx * dy, xz += dx * dz, yy += dy * dy, yz += dy * dz, zz += dz * dz;
    }
    return {count, {sx, sy, sz}, {xx, xy, xz, yy, yz, zz}};
  }

  /// The same for neighbours that are summed already, as seen from the point.
  void add(size_t centre, const PowerSums<2>& sums) {
    add(centre, NeighbourSums{static_cast<size_t>(sums.count()),
                              {sums.of(1, 0, 0), sums.of(0, 1, 0), sums.of(0, 0, 1)},
                              {sums.of(2, 0, 0), sums.of(1, 1, 0), sums.of(1, 0, 1),
                               sums.of(0, 2, 0), sums.of(0, 1, 1), sums.of(0, 0, 2)}});
  }
  void add(size_t centre, const NeighbourSums& sums) {
    const size_t count = sums.count;
    const double inverse = 1 / static_cast<double>(count);
    const auto& [sx, sy, sz] = sums.sum;
    const auto& [xx, xy, xz, yy, yz, zz] = sums.products;
    Symmetric3& m = covariance_[filled_];
    m = {xx - sx * sx * inverse, xy - sx * sy * inverse, xz - sx * sz * inverse,
         yy - sy * sy * inverse, yz - sy * sz * inverse, zz - sz * sz * inverse};
    four_.set(filled_, m[0], m[1], m[2], m[3], m[4], m[5]);
    count_[filled_] = count;
    position_[filled_] = centre;
    squared_offset_[filled_] = (sx * sx + sy * sy + sz * sz) * inverse * inverse;
    offset_[filled_] = {sx * inverse, sy * inverse, sz * inverse};
    if (++filled_ == 4) flush();
  }

  void flush() {
    if (filled_ == 0) return;
    for (int i = filled_; i < 4; ++i) four_.set(i, 1, 0, 0, 2, 0, 3);
    four_.solve();
    for (int i = 0; i < filled_; ++i) {
      if (count_[i] < 3) write(i, nullptr, 0);
      else if (four_.ok[i]) write(i, four_.normal[i], four_.variation[i]);
      else solve_with_care(i);
    }
    filled_ = 0;
  }

 private:
  void solve_with_care(int i) {
    const Eigen3 e = symmetric_eigen(covariance_[i]);
    // All on a line: the second eigenvalue is what rounding leaves of the largest.
    constexpr double kLine = 1e-12;
    if (!(e.values[1] > kLine * e.values[2])) return write(i, nullptr, 0);
    const double normal[3] = {e.vectors[0].x, e.vectors[0].y, e.vectors[0].z};
    write(i, normal, std::max(0.0, e.values[0]) / (e.values[0] + e.values[1] + e.values[2]));
  }
  void write(int i, const double* normal, double variation) {
    write_(NeighbourPlane{position_[i], normal, variation, squared_offset_[i], offset_[i],
                          &covariance_[i], count_[i]});
  }

  const int32_t *x_, *y_, *z_;
  Write write_;
  FourPlanes four_;
  Symmetric3 covariance_[4];
  size_t count_[4], position_[4];
  double squared_offset_[4];
  Vec3 offset_[4];
  int filled_ = 0;
};

}  // namespace jalon
