// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/coarse/plane_match.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/rigid_motion.h"

namespace jalon {

namespace {

constexpr double kSameAngle = 0.07;  // of cosines, about 4 degrees
constexpr double kMostParallel =
    0.94;  // cosine, 20 degrees: two planes closer than this fix no rotation
constexpr double kSameTurn_rad = 0.1;  // rotations this near are one
constexpr size_t kMostTurns = 400;     // different rotations looked at

// The rotation that lays the frame of two directions on that of two others at the same angle.
Transform rotation_of(const Vec3& a1, const Vec3& a2, const Vec3& b1, const Vec3& b2) {
  const Vec3 a[3] = {normalized(a1 + a2), normalized(a1 - a2), normalized(cross(a1 - a2, a1 + a2))};
  const Vec3 b[3] = {normalized(b1 + b2), normalized(b1 - b2), normalized(cross(b1 - b2, b1 + b2))};
  Transform out;
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 3; ++c) {
      double sum = 0;
      for (int k = 0; k < 3; ++k) sum += b[k][r] * a[k][c];
      out.m[static_cast<size_t>(4 * r + c)] = sum;
    }
  return out;
}

struct Turn {
  Transform rotation;
  double area;
};

// The rotations that lay two directions on two others, whichever way round: normals have no sign.
void add_turns(const Vec3& n1, const Vec3& n2, const Vec3& m1, const Vec3& m2, double area,
               bool keep_first, std::vector<Turn>& out) {
  const double angle = dot(n1, n2);
  for (int signs = 0; signs < 4; ++signs) {
    if (keep_first && (signs & 1)) continue;
    const Vec3 to1 = m1 * (signs & 1 ? -1.0 : 1.0), to2 = m2 * (signs & 2 ? -1.0 : 1.0);
    if (std::abs(dot(to1, to2) - angle) <= kSameAngle)
      out.push_back({rotation_of(n1, n2, to1, to2), area});
  }
}

// Every rotation that two pairs of planes give, or one pair and the vertical.
std::vector<Turn> turns_of(const PlaneSets& planes, Task& task) {
  const auto& [reference, moving, level] = planes;
  const auto is_fixing = [](const Vec3& a, const Vec3& b) {
    return std::abs(dot(a, b)) <= kMostParallel;
  };
  constexpr Vec3 kUp{0, 0, 1};
  std::vector<Turn> out;
  for (size_t i = 0; i < moving.size(); ++i) {
    task.checkpoint(static_cast<double>(i) / static_cast<double>(moving.size()));
    const Vec3& n1 = moving[i].plane.normal;
    for (const CoarsePlane& r : reference)
      if (level && is_fixing(kUp, n1))
        add_turns(kUp, n1, kUp, r.plane.normal, common_area(moving[i], r), true, out);
    for (size_t j = i + 1; j < moving.size() && !level; ++j) {
      const Vec3& n2 = moving[j].plane.normal;
      if (!is_fixing(n1, n2)) continue;
      for (const CoarsePlane& r1 : reference)
        for (const CoarsePlane& r2 : reference)
          if (&r1 != &r2)
            add_turns(n1, n2, r1.plane.normal, r2.plane.normal,
                      std::min(common_area(moving[i], r1), common_area(moving[j], r2)), false, out);
    }
  }
  std::stable_sort(out.begin(), out.end(),
                   [](const Turn& a, const Turn& b) { return a.area > b.area; });
  return out;
}

bool is_same_turn(const Transform& a, const Transform& b) {
  double trace = 0;  // of a^T b
  for (size_t r = 0; r < 3; ++r)
    for (size_t c = 0; c < 3; ++c) trace += a.m[4 * r + c] * b.m[4 * r + c];
  return (trace - 1) / 2 > std::cos(kSameTurn_rad);
}

// Area of planes that have a parallel one on the other side.
double parallel_area(const Transform& rotation, const PlaneSets& planes) {
  double sum = 0;
  for (const CoarsePlane& m : planes.moving) {
    double best = 0;
    for (const CoarsePlane& r : planes.reference)
      if (std::abs(dot(rotation.direction(m.plane.normal), r.plane.normal)) >= kParallel)
        best = std::max(best, common_area(m, r));
    sum += best;
  }
  return sum;
}

}  // namespace

std::vector<Transform> plane_rotations(const PlaneSets& planes, size_t most, Task& task) {
  std::vector<Turn> distinct;
  for (const Turn& turn : turns_of(planes, task)) {
    if (distinct.size() == kMostTurns) break;
    const bool is_new = std::none_of(distinct.begin(), distinct.end(), [&](const Turn& other) {
      return is_same_turn(turn.rotation, other.rotation);
    });
    if (is_new) distinct.push_back({turn.rotation, parallel_area(turn.rotation, planes)});
  }
  std::stable_sort(distinct.begin(), distinct.end(),
                   [](const Turn& a, const Turn& b) { return a.area > b.area; });
  if (distinct.size() > most) distinct.resize(most);
  std::vector<Transform> out;
  for (const Turn& turn : distinct) out.push_back(turn.rotation);
  return out;
}

std::vector<Transform> poses_of_largest(const PlaneSets& planes, const CoarseSurface& reference,
                                        const CoarseSurface& moving) {
  std::vector<Transform> out;
  if (planes.reference.empty() || planes.moving.empty()) return out;
  const auto along = [](const Vec3& n) {
    return normalized(cross(n, std::abs(n.z) < 0.8 ? Vec3{0, 0, 1} : Vec3{1, 0, 0}));
  };
  const Vec3 &from = planes.moving[0].plane.normal, &to = planes.reference[0].plane.normal;
  for (const double way : {1.0, -1.0})
    for (int quarter = 0; quarter < 4; ++quarter) {
      const Transform turn = rotation_by(to * (quarter * std::numbers::pi / 2));
      Transform T_reference_moving = turn * rotation_of(from, along(from), to * way, along(to));
      const Vec3 t = reference.centroid - T_reference_moving.direction(moving.centroid);
      T_reference_moving.m[3] = t.x, T_reference_moving.m[7] = t.y, T_reference_moving.m[11] = t.z;
      out.push_back(T_reference_moving);
    }
  return out;
}

}  // namespace jalon
