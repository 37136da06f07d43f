// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "model/relations/placed_face.h"

#include <algorithm>
#include <cmath>

#include "model/chords.h"

namespace jalon {

namespace {

std::vector<Vec3> points_of(const Model& model, const Ring& ring, const Vec3& normal,
                            double chord_error_m) {
  std::vector<Vec3> out;
  for (uint64_t i = 0; i < ring.count; ++i) {
    const uint64_t here = ring.first + i, next = ring.first + (i + 1) % ring.count;
    const Vec3 &a = model.vertices[model.corners[here]], &b = model.vertices[model.corners[next]];
    out.push_back(a);
    for (const Vec3& p : arc_points(a, b, model.sagitta(here), normal, chord_error_m))
      out.push_back(p);
  }
  return out;
}

template <class F>
void for_each_ring(const PolygonWithHoles& polygon, F&& f) {
  f(polygon.outline);
  for (const auto& hole : polygon.holes) f(hole);
}

}  // namespace

PlacedFace placed(const std::vector<std::vector<Vec3>>& rings, const Vec3& normal) {
  PlacedFace out;
  out.origin = rings[0][0];
  out.axes = axes_of(normal);
  out.plane = {normal, dot(normal, out.origin)};
  for (size_t r = 0; r < rings.size(); ++r) {
    std::vector<Vec2> ring;
    for (const Vec3& p : rings[r]) {
      ring.push_back(out.project(p));
      out.box.add(p);
    }
    if (r == 0) out.polygon.outline = std::move(ring);
    else out.polygon.holes.push_back(std::move(ring));
  }
  return out;
}

PlacedFace placed_face(const Model& model, const Face& face, double chord_error_m) {
  const Vec3 normal = normal_of(model, face);
  std::vector<std::vector<Vec3>> rings;
  for (uint64_t r = face.first_ring; r < face.first_ring + face.ring_count; ++r)
    rings.push_back(points_of(model, model.rings[r], normal, chord_error_m));
  return placed(rings, normal);
}

PlacedFace placed_filling(const Model& model, const Face& face, const Ring& hole,
                          double chord_error_m) {
  const Vec3 normal = normal_of(model, face);
  return placed({points_of(model, hole, normal, chord_error_m)}, normal);
}

std::vector<Vec3> corners_of(const PlacedFace& face) {
  std::vector<Vec3> out;
  for_each_ring(face.polygon, [&](const std::vector<Vec2>& ring) {
    for (const Vec2& p : ring) out.push_back(face.lift(p));
  });
  return out;
}

bool are_coplanar(const PlacedFace& a, const PlacedFace& b, double tolerance) {
  const auto lies_in = [&](const PlacedFace& face, const Plane& plane) {
    const auto corners = corners_of(face);
    return std::all_of(corners.begin(), corners.end(),
                       [&](const Vec3& p) { return std::fabs(plane.distance(p)) <= tolerance; });
  };
  return lies_in(a, b.plane) && lies_in(b, a.plane);
}

PolygonWithHoles seen_in(const PlacedFace& face, const PlacedFace& frame) {
  PolygonWithHoles out = face.polygon;
  const auto move = [&](std::vector<Vec2>& ring) {
    for (Vec2& p : ring) p = frame.project(face.lift(p));
  };
  move(out.outline);
  for (auto& hole : out.holes) move(hole);
  return out;
}

bool are_near(const Box3& a, const Box3& b, double reach) {
  for (int k = 0; k < 3; ++k)
    if (a.min[k] > b.max[k] + reach || b.min[k] > a.max[k] + reach) return false;
  return true;
}

double box_distance(const Box3& a, const Box3& b) {
  Vec3 gap;
  for (int k = 0; k < 3; ++k) gap[k] = std::max({0.0, a.min[k] - b.max[k], b.min[k] - a.max[k]});
  return norm(gap);
}

}  // namespace jalon
