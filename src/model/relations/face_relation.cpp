// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "model/relations/face_relation.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/region_relation.h"

namespace jalon {

namespace {

using enum NineIntersection::Place;

constexpr double kParallelSine = 1e-6;  // planes so nearly parallel meet beyond any building

using Polygons = std::span<const PolygonWithHoles>;

struct Segment3 {
  Vec3 from, to;
};

std::vector<Segment3> segments_of(const PlacedFace& face) {
  std::vector<Segment3> out;
  const auto add = [&](const std::vector<Vec2>& ring) {
    for (size_t i = 0; i < ring.size(); ++i)
      out.push_back({face.lift(ring[i]), face.lift(ring[(i + 1) % ring.size()])});
  };
  add(face.polygon.outline);
  for (const auto& hole : face.polygon.holes) add(hole);
  return out;
}

// Least distance of two segments (Ericson 2005, 5.1.9).
double distance_of(const Segment3& p, const Segment3& q) {
  const Vec3 d1 = p.to - p.from, d2 = q.to - q.from, r = p.from - q.from;
  const double a = dot(d1, d1), e = dot(d2, d2), f = dot(d2, r), c = dot(d1, r), b = dot(d1, d2);
  const double det = a * e - b * b;
  double s = det > 0 ? std::clamp((b * f - c * e) / det, 0.0, 1.0) : 0, t = 0;
  if (e > 0) t = (b * s + f) / e;
  if (t < 0 || t > 1) {
    t = std::clamp(t, 0.0, 1.0);
    s = a > 0 ? std::clamp((b * t - c) / a, 0.0, 1.0) : 0;
  }
  return norm(p.from + d1 * s - (q.from + d2 * t));
}

double above_distance(const PlacedFace& a, const PlacedFace& b) {
  const PlaneRegion region(Polygons(&b.polygon, 1));
  double least = std::numeric_limits<double>::infinity();
  for (const Vec3& p : corners_of(a))
    if (const double d = std::fabs(b.plane.distance(p)); d < least && region.contains(b.project(p)))
      least = d;
  return least;
}

NineIntersection in_one_plane(const PlacedFace& a, const PlacedFace& b, double tolerance) {
  const PolygonWithHoles other = seen_in(b, a);
  return region_intersection(Polygons(&a.polygon, 1), Polygons(&other, 1), tolerance);
}

}  // namespace

bool common_line(const Plane& a, const Plane& b, const Vec3& near, Vec3& point, Vec3& direction) {
  direction = cross(a.normal, b.normal);
  const double sine = norm(direction);
  if (sine < kParallelSine) return false;
  // Least step from `near` onto both planes: p = near + x a.normal + y b.normal.
  const double c = dot(a.normal, b.normal), da = a.distance(near), db = b.distance(near);
  const double squared = sine * sine;
  point = near + a.normal * ((-da + c * db) / squared) + b.normal * ((-db + c * da) / squared);
  direction = direction / sine;
  return true;
}

std::vector<double> ring_crossings(const PlacedFace& face, const Vec3& point, const Vec3& direction,
                                   double tolerance) {
  const Vec2 p = face.project(point), d = face.project(point + direction) - p;
  std::vector<double> out;
  const PlaneRegion region(Polygons(&face.polygon, 1));
  for (const auto& [from, to] : region.edges()) {
    const double off = cross(d, from - p), off_to = cross(d, to - p);
    if (std::fabs(off) <= tolerance) out.push_back(dot(d, from - p));
    if ((off < 0) == (off_to < 0)) continue;
    const Vec2 crossing = from + (to - from) * (off / (off - off_to));
    out.push_back(dot(d, crossing - p));
  }
  std::sort(out.begin(), out.end());
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

NineIntersection face_intersection(const PlacedFace& a, const PlacedFace& b, double tolerance) {
  if (are_coplanar(a, b, tolerance)) return in_one_plane(a, b, tolerance);
  NineIntersection out;
  // 1. A surface lies on a line with no part of its extent.
  out.raise(kBoundary, kExterior, 1), out.raise(kExterior, kBoundary, 1);
  out.raise(kInterior, kExterior, 2), out.raise(kExterior, kInterior, 2);
  out.raise(kExterior, kExterior, 3);
  // 2. The common line, cut by both.
  Vec3 point, direction;
  if (!are_near(a.box, b.box, tolerance) ||
      !common_line(a.plane, b.plane, a.origin, point, direction))
    return out;
  std::vector<double> cuts = ring_crossings(a, point, direction, tolerance);
  const auto more = ring_crossings(b, point, direction, tolerance);
  cuts.insert(cuts.end(), more.begin(), more.end());
  std::sort(cuts.begin(), cuts.end());
  // 3. Each cut and each piece between two is judged in both planes.
  const PlaneRegion first(Polygons(&a.polygon, 1)), second(Polygons(&b.polygon, 1));
  const auto judge = [&](double at, int8_t dimension) {
    const Vec3 p = point + direction * at;
    const auto i = first.place_of(a.project(p), tolerance),
               j = second.place_of(b.project(p), tolerance);
    if (i != kExterior && j != kExterior) out.raise(i, j, dimension);
  };
  for (size_t k = 0; k < cuts.size(); ++k) {
    judge(cuts[k], 0);
    if (k + 1 < cuts.size() && cuts[k + 1] - cuts[k] > 2 * tolerance)
      judge((cuts[k] + cuts[k + 1]) / 2, 1);
  }
  return out;
}

double face_distance(const PlacedFace& a, const PlacedFace& b, double tolerance) {
  if (face_intersection(a, b, tolerance).contact() >= 0) return 0;
  double least = std::min(above_distance(a, b), above_distance(b, a));
  const auto mine = segments_of(a), others = segments_of(b);
  for (const Segment3& p : mine)
    for (const Segment3& q : others) least = std::min(least, distance_of(p, q));
  return least;
}

}  // namespace jalon
