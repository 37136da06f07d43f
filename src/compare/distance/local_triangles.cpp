// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/distance/local_triangles.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "spatial/triangles/closest.h"

namespace jalon {

namespace {

// Step of the triangulation's grid as a share of its size: finer than any scanner's noise.
constexpr double kGridShare = 0x1p-24;
// A side that holds the closest point itself may seem to lie a little farther.
constexpr double kRounding = 1 + 1e-9;

Vector<double> vector_of(const Vec3& p) { return {p.x, p.y, p.z}; }

}  // namespace

bool LocalTriangles::set(std::span<const Vec3> points, const Vec3& centroid, const Vec3& u,
                         const Vec3& v) {
  centroid_ = centroid, u_ = u, v_ = v;
  corners_.assign(points.begin(), points.end());
  flat_.clear();
  sides_.clear();
  double size = 0, least = std::numeric_limits<double>::infinity();
  uint32_t origin = 0;
  for (const Vec3& p : points) {
    const Vec3 d = p - centroid;
    flat_.push_back({dot(d, u), dot(d, v)});
    size = std::max({size, std::fabs(flat_.back().u), std::fabs(flat_.back().v)});
    const double squared = squared_norm(p);
    if (squared < least) least = squared, origin = static_cast<uint32_t>(flat_.size() - 1);
  }
  if (!(size > 0)) return false;
  delaunay_.start(flat_, size * kGridShare, origin);
  for (size_t i = 0; i < delaunay_.triangles().size(); ++i) add_sides(i);
  return !delaunay_.triangles().empty();
}

void LocalTriangles::add_sides(size_t triangle) {
  const size_t lane = triangle % kLanes;
  if (lane == 0) sides_.emplace_back();
  Sides& sides = sides_.back();
  const auto& t = delaunay_.triangles()[triangle];
  for (size_t side = 0; side < 3; ++side) {
    const Vec2 from = flat_[t[side]], along = flat_[t[(side + 1) % 3]] - from;
    sides.from_u[side][lane] = from.u, sides.from_v[side][lane] = from.v;
    sides.along_u[side][lane] = along.u, sides.along_v[side][lane] = along.v;
    sides.inverse_squared_length[side][lane] = 1 / dot(along, along);
  }
}

// No triangle is nearer than its projection, and that no nearer than the line of a side that the point lies beyond
// (they are anticlockwise).
void LocalTriangles::measure_away(const Vec2& at) {
  away_.resize(sides_.size());
  for (size_t block = 0; block < sides_.size(); ++block) {
    const Sides& s = sides_[block];
    Doubles most = {};
    for (size_t side = 0; side < 3; ++side) {
      const Doubles cross =
          s.along_u[side] * (at.v - s.from_v[side]) - s.along_v[side] * (at.u - s.from_u[side]);
      const Doubles beyond = cross < 0 ? cross : Doubles{};
      const Doubles squared = beyond * beyond * s.inverse_squared_length[side];
      most = squared > most ? squared : most;
    }
    away_[block] = most;
  }
}

// Corners come in one order: triangles then give the same distance from a side that they share, bit by bit. Of equally
// near points that of the triangle with the first corners is taken, whatever was made before.
void LocalTriangles::consider(size_t triangle, Closest& closest) const {
  std::array<uint32_t, 3> t = delaunay_.triangles()[triangle];
  std::ranges::sort(t);
  const auto found = closest_on_triangle(vector_of(closest.p), vector_of(corners_[t[0]]),
                                         vector_of(corners_[t[1]]), vector_of(corners_[t[2]]));
  if (!(found.squared < closest.squared ||
        (closest.found && found.squared == closest.squared && t < closest.corners)))
    return;
  closest.squared = found.squared;
  closest.corners = t;
  closest.found = true;
  closest.rest = found.on_face ? Vec3{found.normal.x, found.normal.y, found.normal.z} *
                                     (found.height / found.normal2)
                               : Vec3{found.rest.x, found.rest.y, found.rest.z};
}

double LocalTriangles::squared_away(const GrowingDelaunay::Edge& edge, const Vec2& at) const {
  const Vec2 along = flat_[edge.to] - flat_[edge.from], to_at = at - flat_[edge.from];
  double t = dot(to_at, along) / dot(along, along);
  t = t < 1 ? t : 1;
  t = t > 0 ? t : 0;
  const Vec2 rest = to_at - along * t;
  return dot(rest, rest);
}

// The disc about the point that holds all that is near enough, and the hull of the points, are convex, and so is what
// they share; a made triangle reaches into it. So another one that does lies across an edge that does.
bool LocalTriangles::grow_towards(const Vec2& at, double squared) {
  for (;;) {
    const auto border = delaunay_.border();
    size_t nearest = 0;
    double least = std::numeric_limits<double>::infinity();
    for (size_t i = 0; i < border.size(); ++i) {
      const double away = squared_away(border[i], at);
      nearest = away < least ? i : nearest;
      least = std::min(least, away);
    }
    if (!(least <= squared * kRounding)) return false;
    if (delaunay_.grow(nearest)) return true;
  }
}

bool LocalTriangles::foot(const Vec3& p, double limit_m, Vec3& foot) {
  const Vec3 in_plane = p - centroid_;
  const Vec2 at{dot(in_plane, u_), dot(in_plane, v_)};
  Closest closest{p, limit_m * limit_m, {}, {}, false};
  // 1. The triangle below or above the point comes first: it is mostly the nearest, and then few others are looked at.
  measure_away(at);
  const size_t made = delaunay_.triangles().size();
  for (const bool below : {true, false})
    for (size_t i = 0; i < made; ++i)
      if ((away(i) == 0) == below && away(i) <= closest.squared) consider(i, closest);
  // 2. Triangles not yet made that may be nearer.
  while (grow_towards(at, closest.squared)) {
    add_sides(delaunay_.triangles().size() - 1);
    consider(delaunay_.triangles().size() - 1, closest);
  }
  if (closest.found) foot = p - closest.rest;
  return closest.found;
}

}  // namespace jalon
