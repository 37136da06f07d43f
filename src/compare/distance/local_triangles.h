// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/growing_delaunay.h"
#include "geometry/vec.h"

namespace jalon {

/// Points around the origin, which is one of them, as the 2D Delaunay triangles of their projections on a plane, lifted
/// back. Only those triangles are made that can hold the point of the surface closest to a point asked for.
class LocalTriangles {
 public:
  /// u, v: an orthonormal base of the plane. False where the projections have no triangles.
  bool set(std::span<const Vec3> points, const Vec3& centroid, const Vec3& u, const Vec3& v);
  /// The point of the surface closest to p, if it is nearer than limit_m; the origin may be no
  /// farther from p than that.
  bool foot(const Vec3& p, double limit_m, Vec3& foot);
  /// How many triangles have been made.
  size_t made() const { return delaunay_.triangles().size(); }

 private:
  static constexpr size_t kLanes = 2;
  using Doubles = double __attribute__((vector_size(8 * kLanes)));
  /// The sides of the projections of two triangles.
  struct Sides {
    Doubles from_u[3], from_v[3], along_u[3], along_v[3], inverse_squared_length[3];
  };
  struct Closest {
    Vec3 p;
    double squared;                   ///< distance from p
    std::array<uint32_t, 3> corners;  ///< of the triangle, ascending
    Vec3 rest;                        ///< from the closest point to p
    bool found;
  };

  void add_sides(size_t triangle);
  double away(size_t triangle) const { return away_[triangle / kLanes][triangle % kLanes]; }
  void measure_away(const Vec2& at);
  void consider(size_t triangle, Closest& closest) const;
  double squared_away(const GrowingDelaunay::Edge& edge, const Vec2& at) const;
  bool grow_towards(const Vec2& at, double squared);

  Vec3 centroid_, u_, v_;
  std::vector<Vec3> corners_;
  std::vector<Vec2> flat_;
  GrowingDelaunay delaunay_;
  std::vector<Sides> sides_;
  std::vector<Doubles>
      away_;  ///< no more than the squared distance of the triangles from the point asked for
};

}  // namespace jalon
