// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/codes/ajar_leaf.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace jalon {

namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kLeastAjar_rad = 3 * kDegree, kMostAjar_rad = 30 * kDegree,
                 kAjarStep_rad = kDegree / 4;  // 9 mm at the end of 2 m
constexpr double kOnLeaf_m = 0.01;             // five times the noise of a scanner
constexpr double kAtLeaf_m = 0.005;            // as at fronts
constexpr double kNearestHinge_m = 0.05;       // nearer points lie on every plane through it
constexpr double kLeafGap_m = 0.15;            // rails of a frame have no wider one
constexpr double kAboutLeaf_m = 0.05;          // of a hinge whose front was taken for a reveal's
constexpr double kNarrowestLeaf_m = 0.3;
constexpr double kLeafEdge_m = 0.02;  // about its ends, as about measured corners

// The angle of the plane through the hinge that most points lie in; 0: none.
double best_angle(std::span<const Vec2> from_hinge) {
  constexpr auto kAngles = static_cast<size_t>((kMostAjar_rad - kLeastAjar_rad) / kAjarStep_rad);
  std::vector<size_t> votes(kAngles + 1);
  for (const Vec2& p : from_hinge) {
    const double r = norm(p);
    if (r < kNearestHinge_m) continue;
    const double angle = std::atan2(-p.v, p.u), about = std::asin(kOnLeaf_m / r);
    const double first = std::ceil((angle - about - kLeastAjar_rad) / kAjarStep_rad),
                 last = std::floor((angle + about - kLeastAjar_rad) / kAjarStep_rad);
    for (double k = std::max(0.0, first); k <= std::min<double>(kAngles, last); ++k)
      ++votes[static_cast<size_t>(k)];
  }
  const auto most = std::max_element(votes.begin(), votes.end());
  return *most == 0 ? 0
                    : kLeastAjar_rad + kAjarStep_rad * static_cast<double>(most - votes.begin());
}

// From the hinge on, as far as places follow one another.
double end_of(std::vector<double> places) {
  std::sort(places.begin(), places.end());
  double end = 0;
  for (const double s : places) {
    if (s - end > kLeafGap_m) break;
    end = std::max(end, s);
  }
  return end;
}

size_t points_at_front(std::span<const Vec3> points, const OpeningFront& front,
                       const OpeningEnds& ends) {
  return static_cast<size_t>(std::count_if(points.begin(), points.end(), [&](const Vec3& p) {
    return p.x > ends.left_m && p.x < ends.right_m && p.z > ends.low_m && p.z < ends.high_m &&
           std::fabs(p.y - front.before(p.x)) < kAtLeaf_m;
  }));
}

}  // namespace

Vec3 AjarLeaf::of(const Vec3& p) const {
  const Vec2 d{p.x - hinge.u, p.y - hinge.v};
  return {dot(d, along), dot(d, outward()), p.z};
}

bool AjarLeaf::holds(const Vec3& p, double distance_m) const {
  const Vec3 at = of(p);
  return at.x > -kLeafEdge_m && at.x < length_m + kLeafEdge_m && p.z > low_m - kLeafEdge_m &&
         p.z < high_m + kLeafEdge_m && at.y < kBeforeFront_m && at.y > -distance_m;
}

bool find_ajar_leaf(std::span<const Vec3> points, const OpeningFront& front, double hinge_m,
                    double reach_m, double low_m, double high_m, AjarLeaf& leaf) {
  leaf = {};
  leaf.hinge = {hinge_m, front.before(hinge_m)};
  leaf.low_m = low_m, leaf.high_m = high_m;
  const double way = reach_m > 0 ? 1 : -1, reach = std::fabs(reach_m);
  // 1. The plane that most points lie in.
  std::vector<Vec2> from_hinge;
  std::vector<Vec3> about;
  for (const Vec3& p : points) {
    const Vec2 d{way * (p.x - leaf.hinge.u), p.y - leaf.hinge.v};
    if (d.u < 0 || d.u > reach || p.z < low_m || p.z > high_m) continue;
    from_hinge.push_back(d);
    about.push_back(p);
  }
  const double angle = best_angle(from_hinge);
  if (angle == 0) return false;
  leaf.along = {way * std::cos(angle), -std::sin(angle)};
  // 2. Its front among what lies about that plane, wherever the hinge is exactly.
  std::vector<Vec3> on;
  for (const Vec3& p : about)
    if (const Vec3 at = leaf.of(p); std::fabs(at.y) < kAboutLeaf_m && at.x < reach)
      on.push_back(at);
  OpeningFront own;
  if (!find_opening_front(on, own)) return false;
  leaf.hinge = leaf.hinge + leaf.outward() * own.at_m;
  leaf.along = (leaf.along + leaf.outward() * own.slope) * (1 / std::hypot(1.0, own.slope));
  if (-leaf.along.v < std::sin(kLeastAjar_rad)) return false;  // shut
  // 3. How far it reaches.
  std::vector<double> places;
  for (const Vec3& p : about)
    if (const Vec3 at = leaf.of(p); std::fabs(at.y) < kOnLeaf_m) places.push_back(at.x);
  leaf.length_m = end_of(std::move(places));
  if (leaf.length_m < kNarrowestLeaf_m) return false;
  for (const Vec3& p : about) {
    const Vec3 at = leaf.of(p);
    leaf.points += at.x < leaf.length_m && std::fabs(at.y) < kAtLeaf_m;
  }
  return true;
}

bool find_ajar_leaf(std::span<const Vec3> points, const OpeningFront& front,
                    const OpeningEnds& ends, double reach_m, AjarLeaf& leaf) {
  // A front that slants is that of a leaf, as far as it was followed.
  size_t most =
      std::fabs(front.slope) < std::tan(kLeastAjar_rad) ? points_at_front(points, front, ends) : 0;
  bool is_found = false;
  for (const bool is_left : {true, false}) {
    AjarLeaf about_end;
    if (!find_ajar_leaf(points, front, is_left ? ends.left_m : ends.right_m,
                        is_left ? reach_m : -reach_m, ends.low_m, ends.high_m, about_end) ||
        about_end.points <= most)
      continue;
    most = about_end.points;
    leaf = about_end;
    is_found = true;
  }
  return is_found;
}

}  // namespace jalon
