// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "base/task.h"
#include "geometry/vec.h"
#include "spatial/octree/octree.h"

namespace jalon {

/// Points of one object with what is needed to lay another one onto it.
class MatchSurface {
 public:
  /// points: near the origin of their frame.
  MatchSurface(std::vector<Vec3> points, Task& task);

  size_t size() const { return points_.size(); }
  const std::vector<Vec3>& points() const { return points_; }
  /// Of the local plane; zero where there is none.
  const Vec3& normal(size_t i) const { return normals_[i]; }
  /// Away from edges and curves: its neighbours scatter about their plane as most points' do.
  bool is_flat(size_t i) const { return scatter_[i] <= flat_scatter_; }
  /// Radius of the disc that the point stands for.
  double radius(size_t i) const { return radii_[i]; }
  double median_radius() const { return median_radius_; }
  const Vec3& centroid() const { return centroid_; }
  const Box3& box() const { return box_; }
  Neighbour nearest(const Vec3& p) const;
  /// At most this many of its points, evenly taken.
  std::vector<Vec3> sample(size_t most) const;

 private:
  void measure(Task& task);

  std::vector<Vec3> points_, normals_;
  std::vector<double> radii_, scatter_;
  double median_radius_ = 0, flat_scatter_ = 0;
  Vec3 centroid_;
  Box3 box_;
  Buffer<double> xyz_;
  std::shared_ptr<const Octree> tree_;
};

}  // namespace jalon
