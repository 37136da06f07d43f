// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <vector>

#include "registration/coarse/feature_histogram.h"
#include "unit/registration/coarse_scenes.h"

namespace jalon::test {

/// Thinned surfaces made by hand, so that every count is known: cells with their normals.
class Cells {
 public:
  /// nu x nv cells, a step of u and v apart, all of one plane.
  Cells& sheet(const Vec3& corner, const Vec3& u, const Vec3& v, int nu, int nv) {
    for (int i = 0; i < nu; ++i)
      for (int k = 0; k < nv; ++k) add(corner + u * i + v * k, normalized(cross(u, v)));
    return *this;
  }
  Cells& add(const Vec3& point, const Vec3& normal) {
    points_.push_back(point);
    normals_.push_back(normal);
    return *this;
  }
  /// Flat wherever there is a normal, all weights 1, without features.
  CoarseSurface surface(double cell_m = 1) const {
    CoarseSurface s;
    s.cell_m = cell_m;
    s.points = points_;
    s.normals = normals_;
    s.xyz = Buffer<double>(3 * s.size());
    Box3 box;
    for (size_t i = 0; i < s.size(); ++i) {
      box.add(s.points[i]);
      s.centroid += s.points[i] / static_cast<double>(s.size());
      for (int c = 0; c < 3; ++c) s.xyz[3 * i + static_cast<size_t>(c)] = s.points[i][c];
      s.variation.push_back(squared_norm(s.normals[i]) > 0 ? 0 : 1);
    }
    double squares = 0;
    for (const Vec3& p : s.points) squares += squared_norm(p - s.centroid);
    s.extent_m = std::sqrt(squares / static_cast<double>(s.size()));
    s.scatter_m2.assign(s.size(), 0);
    s.weights.assign(s.size(), 1);
    Task task;
    s.tree = Octree::build(s.xyz, enclosing_cube(box), task);
    return s;
  }

 private:
  std::vector<Vec3> points_, normals_;
};

/// A sample as coarse registration sees it.
inline CoarseSurface described_surface(const std::vector<Vec3>& points, double cell_m) {
  Task task;
  CoarseSurface s = coarse_surface(cloud_of(points), cell_m, task);
  describe_features(s, 5 * cell_m, 4000, task);
  return s;
}

/// A pose between the caller's coordinates, as one between the surfaces' own frames.
inline Transform between_surfaces(const Transform& pose, const CoarseSurface& reference,
                                  const CoarseSurface& moving) {
  return motion_about({}, {}, -reference.origin) * pose * motion_about({}, {}, moving.origin);
}

inline std::vector<Vec3> moved_points(std::vector<Vec3> points, const Transform& by) {
  for (Vec3& p : points) p = by.point(p);
  return points;
}

/// The farthest that two poses put a point of a surface apart.
inline double farthest_apart(const Transform& a, const Transform& b, const CoarseSurface& s) {
  double most = 0;
  for (const Vec3& p : s.points) most = std::max(most, norm(a.point(p) - b.point(p)));
  return most;
}

}  // namespace jalon::test
