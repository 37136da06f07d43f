// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/matching/match_starts.h"

#include <cmath>
#include <limits>
#include <numbers>

#include "geometry/plane.h"
#include "geometry/rigid_motion.h"

namespace jalon {

namespace {

constexpr int kBoxAngles = 45;  // every 2 degrees of a quarter turn: ICP does the rest
constexpr size_t kBoxSample = 4000;
// What fell over is as large as it was and has another height: without that it is no more than turned about up.
constexpr double kSameHeight = 1.15, kSameExtent = 1.3;

struct Range {
  double low = std::numeric_limits<double>::infinity(),
         high = -std::numeric_limits<double>::infinity();
  void add(double v) {
    low = std::min(low, v);
    high = std::max(high, v);
  }
  double width() const { return high - low; }
  double middle() const { return (low + high) / 2; }
};

// T that takes the frame (centre, axes) a to b.
Transform frame_to_frame(const Vec3& centre_a, const Vec3 (&a)[3], const Vec3& centre_b,
                         const Vec3 (&b)[3]) {
  Transform out;
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 3; ++c) {
      double sum = 0;
      for (int k = 0; k < 3; ++k) sum += b[k][r] * a[k][c];
      out.m[static_cast<size_t>(4 * r + c)] = sum;
    }
  const Vec3 t = centre_b - out.direction(centre_a);
  out.m[3] = t.x;
  out.m[7] = t.y;
  out.m[11] = t.z;
  return out;
}

Transform shift_by(const Vec3& d) { return motion_about({}, {}, d); }

void add_standing(const MatchSurface& before, const MatchSurface& after, const Vec3& up,
                  std::vector<Transform>& out) {
  const StandingBox a = standing_box(before.sample(kBoxSample), up),
                    b = standing_box(after.sample(kBoxSample), up);
  // What stands keeps its foot: only the sides are shifted onto each other.
  const Vec3 from = a.centre - a.up * a.half[2], to = b.centre - b.up * b.half[2];
  const Vec3 axes_a[3] = {a.along, a.across, a.up};
  for (int quarter = 0; quarter < 4; ++quarter) {
    const Vec3 along = (quarter % 2 == 0 ? b.along : b.across) * (quarter < 2 ? 1.0 : -1.0);
    const Vec3 axes_b[3] = {along, cross(b.up, along), b.up};
    out.push_back(frame_to_frame(from, axes_a, to, axes_b));
  }
  out.push_back(shift_by(to - from));
}

bool are_like(double a, double b, double ratio) { return std::max(a, b) <= ratio * std::min(a, b); }

// Does the box have the extents of another one whose axes take the places of order?
bool fits(const StandingBox& a, const StandingBox& b, const int (&order)[3]) {
  for (int k = 0; k < 3; ++k)
    if (!are_like(a.half[k], b.half[order[k]], kSameExtent)) return false;
  return true;
}

// Quarter turns off the support that lay one box on the other: a cabinet that lies on its side.
void add_fallen(const MatchSurface& before, const MatchSurface& after, const Vec3& up,
                std::vector<Transform>& out) {
  const StandingBox a = standing_box(before.sample(kBoxSample), up),
                    b = standing_box(after.sample(kBoxSample), up);
  if (are_like(a.half[2], b.half[2], kSameHeight)) return;
  const Vec3 axes_a[3] = {a.along, a.across, a.up}, of_b[3] = {b.along, b.across, b.up};
  constexpr int kOffUp[4][3] = {{0, 2, 1}, {2, 1, 0}, {1, 2, 0}, {2, 0, 1}};
  for (const auto& order : kOffUp) {
    if (!fits(a, b, order)) continue;
    for (int flip = 0; flip < 4; ++flip) {
      const Vec3 first = of_b[order[0]] * (flip & 1 ? -1.0 : 1.0),
                 second = of_b[order[1]] * (flip & 2 ? -1.0 : 1.0);
      const Vec3 axes_b[3] = {first, second, cross(first, second)};
      out.push_back(frame_to_frame(a.centre, axes_a, b.centre, axes_b));
    }
  }
}

void add_axes(const MatchSurface& before, const MatchSurface& after, std::vector<Transform>& out) {
  const auto axes_of = [](const MatchSurface& s) {
    Moments moments;
    moments.reference = s.centroid();
    for (const Vec3& p : s.points()) moments.add(p);
    return symmetric_eigen(moments.covariance());
  };
  const Eigen3 a = axes_of(before), b = axes_of(after);
  const Vec3 axes_a[3] = {a.vectors[0], a.vectors[1], a.vectors[2]};
  for (int flip = 0; flip < 4; ++flip) {  // the right-handed choices of signs
    const double s0 = flip & 1 ? -1 : 1, s1 = flip & 2 ? -1 : 1;
    const Vec3 axes_b[3] = {b.vectors[0] * s0, b.vectors[1] * s1, b.vectors[2] * (s0 * s1)};
    out.push_back(frame_to_frame(before.centroid(), axes_a, after.centroid(), axes_b));
  }
}

}  // namespace

bool StandingBox::contains(const Vec3& p, double margin) const {
  const Vec3 d = p - centre;
  return std::abs(dot(d, along)) <= half[0] + margin &&
         std::abs(dot(d, across)) <= half[1] + margin && std::abs(dot(d, up)) <= half[2] + margin;
}

StandingBox standing_box(const std::vector<Vec3>& points, const Vec3& up) {
  const Vec3 helper = std::abs(up.x) < 0.8 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
  const Vec3 e = normalized(cross(up, helper)), f = cross(up, e);
  StandingBox best;
  double least = std::numeric_limits<double>::infinity();
  for (int k = 0; k < kBoxAngles; ++k) {
    const double angle = std::numbers::pi / 2 * k / kBoxAngles;
    const Vec3 along = e * std::cos(angle) + f * std::sin(angle), across = cross(up, along);
    Range u, v, w;
    for (const Vec3& p : points) {
      u.add(dot(p, along));
      v.add(dot(p, across));
      w.add(dot(p, up));
    }
    if (!(u.width() * v.width() < least)) continue;
    least = u.width() * v.width();
    best = {up,
            across,
            along,
            along * u.middle() + across * v.middle() + up * w.middle(),
            {u.width() / 2, v.width() / 2, w.width() / 2}};
  }
  return best;
}

std::vector<Transform> match_starts(const MatchSurface& before, const MatchSurface& after,
                                    const MatchSetting& setting) {
  std::vector<Transform> out{Transform{}, shift_by(after.centroid() - before.centroid())};
  if (!setting.stands) {
    add_axes(before, after, out);
    return out;
  }
  add_standing(before, after, setting.up, out);
  add_fallen(before, after, setting.up, out);
  return out;
}

}  // namespace jalon
