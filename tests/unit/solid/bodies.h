// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "solid/convex_piece.h"
#include "unit/solid/brute_force.h"

namespace jalon::test {

inline Transform frame_of(const brute::Quaternion& q, const Vec3& at) {
  const brute::Rotation r = brute::rotation_of(q);
  Transform t;
  for (size_t i = 0; i < 3; ++i) {
    for (size_t j = 0; j < 3; ++j) t.m[4 * i + j] = r.m[i][j];
    t.m[4 * i + 3] = at[int(i)];
  }
  return t;
}

/// Turned by up to 3 rad, within 2 m of the origin about each axis.
inline Transform any_frame(RandomStream& random) {
  const brute::Quaternion turn = brute::any_turn(random, 3);
  return frame_of(turn, brute::any_vector(random, 2));
}

/// A piece and its analytic distance.
struct Body {
  ConvexPiece piece;
  brute::Distance distance;
};

inline std::vector<Vec3> box_corners(const Vec3& size) {
  std::vector<Vec3> out;
  for (int i = 0; i < 8; ++i)
    out.push_back(
        {(i & 1 ? .5 : -.5) * size.x, (i & 2 ? .5 : -.5) * size.y, (i & 4 ? .5 : -.5) * size.z});
  return out;
}

/// Body number kind of 4 in a random frame; the hull is that of a box with points on its sides and inside.
inline Body any_body(RandomStream& random, int kind) {
  const brute::Quaternion q = brute::any_turn(random, 3);
  const Vec3 at = brute::any_vector(random, 1),
             size = brute::any_vector(random, 0.8) + Vec3{1, 1, 1};
  const Transform frame = frame_of(q, at);
  const auto placed = [=](brute::Distance local) -> brute::Distance {
    return [=, r = brute::rotation_of(q)](const Vec3& p) { return local(r.back(p - at)); };
  };
  if (kind == 0) return {ConvexPiece::box(frame, size), placed(brute::box(size))};
  if (kind == 1) return {ConvexPiece::sphere(at, size.x), placed(brute::ball(size.x))};
  if (kind == 2)
    return {ConvexPiece::cylinder(frame, size.x, size.z), placed(brute::cylinder(size.x, size.z))};
  std::vector<Vec3> points = box_corners(size);
  for (int i = 0; i < 20; ++i) {
    Vec3 p = brute::any_vector(random, 0.5);
    if (i % 2 == 0) p[i % 3] = i % 4 < 2 ? -0.5 : 0.5;
    points.push_back({p.x * size.x, p.y * size.y, p.z * size.z});
  }
  for (Vec3& p : points) p = frame.point(p);
  return {ConvexPiece::hull(points), placed(brute::box(size))};
}

}  // namespace jalon::test
