// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "model/relations/solid_relation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "geometry/region_relation.h"
#include "model/relations/face_relation.h"

namespace jalon {

namespace {

using enum NineIntersection::Place;
using Trace = PlaneRegion::Edge;

// In tolerances: from a cut to the points that tell its two sides apart; shorter pieces end too near to other cuts.
constexpr double kAside = 2, kShortest = 2;

// What the faces of a solid leave in the plane of a face: the lines that cut it, and what lies in the plane.
struct Traces {
  std::vector<Trace> lines;
  std::vector<PolygonWithHoles> coplanar;
};

// Where a face crosses the plane of another, in that one's coordinates.
void add_crossing(const PlacedFace& face, const PlacedFace& other, double tolerance, Traces& out) {
  Vec3 point, direction;
  if (!common_line(face.plane, other.plane, other.origin, point, direction)) return;
  const PlaneRegion region(std::span<const PolygonWithHoles>(&other.polygon, 1));
  const std::vector<double> cuts = ring_crossings(other, point, direction, tolerance);
  for (size_t k = 0; k + 1 < cuts.size(); ++k) {
    const Vec3 middle = point + direction * ((cuts[k] + cuts[k + 1]) / 2);
    if (region.place_of(other.project(middle), tolerance) == kExterior) continue;
    out.lines.push_back(
        {face.project(point + direction * cuts[k]), face.project(point + direction * cuts[k + 1])});
  }
}

Traces traces_on(const PlacedFace& face, const PlacedSolid& solid, double tolerance) {
  Traces out;
  out.lines = PlaneRegion(std::span<const PolygonWithHoles>(&face.polygon, 1)).edges();
  for (const PlacedFace& other : solid.faces) {
    if (!are_near(face.box, other.box, tolerance)) continue;
    if (!are_coplanar(face, other, tolerance)) {
      add_crossing(face, other, tolerance, out);
      continue;
    }
    out.coplanar.push_back(seen_in(other, face));
    const auto edges = PlaneRegion(std::span(out.coplanar).last(1)).edges();
    out.lines.insert(out.lines.end(), edges.begin(), edges.end());
  }
  return out;
}

// Points of the face on both sides of each piece of its cuts.
template <class F>
void for_each_sample(const PlacedFace& face, const Traces& traces, double tolerance, F&& f) {
  const PlaneRegion region(std::span<const PolygonWithHoles>(&face.polygon, 1));
  for (const Trace& line : traces.lines) {
    const Vec2 step = line.to - line.from;
    const double length = norm(step);
    if (!(length > 0)) continue;
    const Vec2 aside = Vec2{-step.v, step.u} * (kAside * tolerance / length);
    const std::vector<double> cuts = cuts_of(line, traces.lines, tolerance);
    for (size_t k = 0; k + 1 < cuts.size(); ++k) {
      if ((cuts[k + 1] - cuts[k]) * length < kShortest * tolerance) continue;
      const Vec2 middle = line.at((cuts[k] + cuts[k + 1]) / 2);
      for (const Vec2& p : {middle + aside, middle - aside})
        if (region.place_of(p, tolerance / 2) == kInterior) f(p);
    }
  }
}

// Step 1: the faces of A, part by part on, in or out of B.
void judge_faces(const PlacedSolid& a, const PlacedSolid& b, double tolerance,
                 NineIntersection& out) {
  for (const PlacedFace& face : a.faces) {
    if (!are_near(face.box, b.box, tolerance)) {
      out.raise(kBoundary, kExterior, 2);
      continue;
    }
    for (const PlacedFace& other : b.faces)
      if (are_near(face.box, other.box, tolerance))
        out.raise(kBoundary, kBoundary, face_intersection(face, other, tolerance).contact());
    const Traces traces = traces_on(face, b, tolerance);
    const PlaneRegion coplanar{traces.coplanar};
    for_each_sample(face, traces, tolerance, [&](const Vec2& p) {
      if (!coplanar.contains(p))
        out.raise(kBoundary, b.contains(face.lift(p)) ? kInterior : kExterior, 2);
    });
  }
}

// Step 2: points just behind the faces of A stand for what no face of B runs through.
void judge_volume(const PlacedSolid& a, const PlacedSolid& b, double tolerance,
                  NineIntersection& out) {
  if (!out.is_empty(kBoundary, kInterior)) out.raise(kInterior, kInterior, 3);
  if (!out.is_empty(kBoundary, kExterior)) out.raise(kInterior, kExterior, 3);
  if (!out.is_empty(kInterior, kBoundary)) {
    out.raise(kInterior, kInterior, 3);
    out.raise(kInterior, kExterior, 3);
    return;
  }
  for (const PlacedFace& face : a.faces)
    for (const Vec2& q :
         PlaneRegion(std::span<const PolygonWithHoles>(&face.polygon, 1)).inner_points()) {
      const Vec3 p = face.lift(q) - face.plane.normal * (kAside * tolerance);
      if (a.contains(p)) out.raise(kInterior, b.contains(p) ? kInterior : kExterior, 3);
    }
}

}  // namespace

bool PlacedSolid::contains(const Vec3& p) const {
  double angle = 0;
  for (const auto& t : triangles) {
    const Vec3 a = t[0] - p, b = t[1] - p, c = t[2] - p;
    const double x = norm(a), y = norm(b), z = norm(c);
    angle += 2 * std::atan2(dot(a, cross(b, c)),
                            x * y * z + dot(a, b) * z + dot(b, c) * x + dot(c, a) * y);
  }
  return angle > 2 * std::numbers::pi;  // half of the full angle
}

PlacedSolid placed_solid(const Model& model, const Solid& solid, double chord_error_m) {
  PlacedSolid out;
  for (uint64_t f = solid.first_face; f < solid.first_face + solid.face_count; ++f) {
    PlacedFace face = placed_face(model, model.faces[f], chord_error_m);
    std::vector<std::vector<Vec2>> rings{face.polygon.outline};
    rings.insert(rings.end(), face.polygon.holes.begin(), face.polygon.holes.end());
    const std::vector<Vec3> corners = corners_of(face);
    for (const auto& t : triangulate(rings))
      out.triangles.push_back({corners[t[0]], corners[t[1]], corners[t[2]]});
    out.box += face.box;
    out.faces.push_back(std::move(face));
  }
  return out;
}

NineIntersection solid_intersection(const PlacedSolid& a, const PlacedSolid& b, double tolerance) {
  NineIntersection out;
  judge_faces(a, b, tolerance, out);
  NineIntersection reverse = out.transposed();
  judge_faces(b, a, tolerance, reverse);
  out = reverse.transposed();
  judge_volume(a, b, tolerance, out);
  reverse = out.transposed();
  judge_volume(b, a, tolerance, reverse);
  out = reverse.transposed();
  out.raise(kExterior, kExterior, 3);
  return out;
}

double solid_distance(const PlacedSolid& a, const PlacedSolid& b, double tolerance) {
  if (solid_intersection(a, b, tolerance).contact() >= 0) return 0;
  double least = std::numeric_limits<double>::infinity();
  for (const PlacedFace& p : a.faces)
    for (const PlacedFace& q : b.faces)
      if (box_distance(p.box, q.box) < least)
        least = std::min(least, face_distance(p, q, tolerance));
  return least;
}

}  // namespace jalon
