// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "compare/distance/local_triangles.h"
#include "geometry/quadric.h"
#include "geometry/vec.h"

namespace jalon {

/// A piece of surface through points around one of them, their centre; all coordinates are relative to it (m).
/// Girardeau-Montaut 2006, 2.3.2.
class LocalSurface {
 public:
  /// The least-squares plane of the points: unit normal, centroid, and how far from the centre the plane stands for the
  /// surface.
  void set_plane(const Vec3& normal, const Vec3& centroid, double reach_m);
  /// Beside the plane: a quadric height function over it. False where the points do not fix one.
  bool set_quadric(std::span<const Vec3> points);
  /// Beside the plane: the 2D Delaunay triangles of the points projected on it, lifted. False where there are none.
  bool set_triangles(std::span<const Vec3> points);

  /// The point of the surface closest to p, if it is within reach; of triangles, if it is nearer than limit_m.
  bool foot_on_plane(const Vec3& p, Vec3& foot) const;
  bool foot_on_quadric(const Vec3& p, Vec3& foot) const;
  bool foot_on_triangles(const Vec3& p, double limit_m, Vec3& foot) {
    return triangles_.foot(p, limit_m, foot);
  }

 private:
  Vec3 to_frame(const Vec3& p) const;
  bool within_reach(const Vec3& foot) const { return squared_norm(foot) <= reach_m_ * reach_m_; }

  Vec3 normal_, centroid_, u_, v_;
  double reach_m_ = 0;
  Quadric quadric_;
  double scale_ = 0;
  std::vector<Vec3> work_;
  LocalTriangles triangles_;
};

}  // namespace jalon
