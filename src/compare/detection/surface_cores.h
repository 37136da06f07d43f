// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "cloud/cloud.h"

namespace jalon {

/// The least-squares plane through the points about one of them.
struct SurfaceCore {
  Vec3 centroid;  ///< local: relative to an origin of the caller's
  Vec3 normal, axis_u, axis_v;
  double sigma_m = 0;                   ///< of the points about the plane
  double spread_u2 = 0, spread_v2 = 0;  ///< variances of the points along the axes, m^2
  double radius_m = 0;                  ///< of the farthest point: what the plane speaks for
  uint32_t point = 0;                   ///< index of the one that it lies about
  uint32_t count = 0;                   ///< points; below 4 there is no plane
  /// How the points rise over the plane with the square of their distance from the centroid, and how sure that is;
  /// both 0 of too few points.
  float curving_per_m = 0, curving_sigma_per_m = 0;

  bool has_plane() const { return count >= 4; }
  /// In the plane, from the centroid, in standard deviations squared: a disc ends at 4.
  double aside2(const Vec3& p) const;
  /// Variance of the plane's height at p by the scatter of its points, m^2.
  double variance_at(const Vec3& p) const { return height_variance() + lever_variance_at(p); }
  /// Mean square of the points' distance from the centroid, in the plane.
  double spread2() const { return spread_u2 + spread_v2; }
  double height_variance() const { return sigma_m * sigma_m / count; }  ///< at the centroid
  /// What the uncertain slope adds at p.
  double lever_variance_at(const Vec3& p) const { return height_variance() * aside2(p); }
};

/// Planes that stand for all of a cloud: about every so many of its points, in the order of its octree.
class SurfaceCores {
 public:
  SurfaceCores(const Cloud& cloud, const Vec3& origin, Task& task);
  size_t size() const { return cores_.size(); }
  const SurfaceCore& operator[](size_t k) const { return cores_[k]; }
  /// The cores whose points lie nearest to a local place, nearest first.
  size_t nearest(const Vec3& place, uint32_t k, std::span<Neighbour> out) const;
  /// Of their points, in the cloud's own coordinates.
  const Octree& tree() const { return *tree_; }
  /// Are they of the points of this tree, relative to this origin?
  bool is_of(const Octree& points, const Vec3& origin) const {
    return points_.get() == &points && origin_ == origin;
  }
  /// What the scatter of points about planes is where the surface is smooth: noise. 0 without planes.
  double noise_m() const { return noise_m_; }

 private:
  void measure_noise();
  std::vector<SurfaceCore> cores_;
  Vec3 origin_;
  Buffer<double> xyz_;
  std::shared_ptr<const Octree> points_, tree_;
  double noise_m_ = 0;
};

}  // namespace jalon
