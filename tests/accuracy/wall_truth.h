// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0

// Walls and openings of a scene as exact polygons, and what a model has in their planes.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "model/model.h"
#include "model/part_classes.h"
#include "shapes.h"

namespace jalon::test {

struct Curve {
  Vec2 centre;
  double radius_m = 0, sagitta_m = 0;
};

/// A ring in the plane of a wall: corners, arcs, and the region that they bound.
struct Drawn {
  std::string part_class;
  Evidence evidence = Evidence::kNone;
  std::vector<Vec2> corners;
  std::vector<double> heights_m;  ///< of the corners over the true plane
  std::vector<Curve> arcs;
  Region region;
};

/// u along the wall to the right, v up, n out of it.
struct WallAxes {
  Vec3 origin, u, v, n;
  explicit WallAxes(const Plane& plane = {}, const Vec3& at = {}) : origin(at), n(plane.normal) {
    u = normalized(cross({0, 0, 1}, n));
    v = cross(n, u);
  }
  Vec2 project(const Vec3& p) const { return {dot(p - origin, u), dot(p - origin, v)}; }
  double height_m(const Vec3& p) const { return dot(p - origin, n); }
};

struct Wall {
  std::string name;
  uint32_t face_id = 0;  ///< of the true face: that of its points
  WallAxes axes;
  Region region;                ///< all faces in its plane
  std::vector<Drawn> outlines;  ///< of those faces
  std::vector<Drawn> openings;
};

/// The arc from a to b, without a: chords of 2 degrees, within 0.1 mm of an arc of half a metre.
inline void append_chords(std::vector<Vec2>& out, const Vec2& a, const Vec2& b, double sagitta_m,
                          Curve& curve) {
  const Vec2 chord = b - a, right = {chord.v, -chord.u};
  const double length = std::hypot(chord.u, chord.v), s = std::fabs(sagitta_m);
  const double radius = (length * length / 4 + s * s) / (2 * s), side = sagitta_m > 0 ? 1 : -1;
  const Vec2 centre = (a + b) * 0.5 + right * (side * (s - radius) / length);
  curve = {centre, radius, s};
  const double turn =
      side * 4 * std::atan2(2 * s, length);  // anticlockwise where the arc bulges to the right
  const double from = std::atan2(a.v - centre.v, a.u - centre.u);
  const int pieces = std::max(2, static_cast<int>(std::fabs(turn) * 57.3 / 2));
  for (int k = 1; k < pieces; ++k) {
    const double angle = from + turn * k / pieces;
    out.push_back({centre.u + radius * std::cos(angle), centre.v + radius * std::sin(angle)});
  }
  out.push_back(b);
}

/// A ring of a model as it lies in the wall's plane.
inline Drawn drawn(const Model& model, const Ring& ring, bool same_side, const WallAxes& axes) {
  Drawn out;
  std::vector<Vec2> chords;
  for (uint64_t k = 0; k < ring.count; ++k) {
    const Vec3& p = model.vertices[model.corners[ring.first + k]];
    out.corners.push_back(axes.project(p));
    out.heights_m.push_back(axes.height_m(p));
  }
  for (uint64_t k = 0; k < ring.count; ++k) {
    const Vec2 &a = out.corners[k], &b = out.corners[(k + 1) % ring.count];
    const double sagitta_m = model.sagitta(ring.first + k) * (same_side ? 1 : -1);
    if (sagitta_m == 0) chords.push_back(b);
    else append_chords(chords, a, b, sagitta_m, out.arcs.emplace_back());
  }
  out.region = {{{chords}}};
  return out;
}

/// The scenes draw round heads as chords between the springing points: takes the chords off the corners.
inline void find_head(Drawn& ring) {
  const size_t n = ring.corners.size();
  if (n <= 6) return;
  const auto at = [&](size_t i) { return ring.corners[i % n]; };
  size_t sill = 0;
  const auto level = [&](size_t i) { return at(i).v + at(i + 1).v; };
  for (size_t i = 1; i < n; ++i)
    if (level(i) < level(sill)) sill = i;
  const Vec2 a = at(sill + 2), b = at(sill + n - 1), top = at(sill + 2 + (n - 3) / 2);
  const Vec2 ab = b - a, ac = top - a;
  const double d = 2 * cross(ab, ac), bb = dot(ab, ab), cc = dot(ac, ac);
  const Vec2 centre = a + Vec2{ac.v * bb - ab.v * cc, ab.u * cc - ac.u * bb} * (1 / d);
  const double radius = std::hypot(a.u - centre.u, a.v - centre.v);
  ring.arcs = {{centre, radius, centre.v + radius - a.v}};
  ring.corners = {at(sill), at(sill + 1), a, b};
  ring.heights_m.assign(4, 0);
}

inline bool in_plane(const WallAxes& axes, const Face& face, const Drawn& outline,
                     double tolerance_m) {
  double mean = 0;
  for (const double h : outline.heights_m)
    mean += h / static_cast<double>(outline.heights_m.size());
  return std::fabs(dot(axes.n, face.plane.normal)) > std::cos(0.035) &&
         std::fabs(mean) < tolerance_m;
}

/// The faces for which `is_wall` holds, with all that the scene has in their planes.
inline std::vector<Wall> true_walls(const Model& scene,
                                    const std::function<bool(const Face&)>& is_wall) {
  std::vector<Wall> out;
  for (const Face& face : scene.faces) {
    if (!is_wall(face)) continue;
    Wall wall;
    wall.name = scene.parts[face.part].name;
    wall.face_id = face.id;
    wall.axes =
        WallAxes(face.plane, scene.vertices[scene.corners[scene.rings[face.first_ring].first]]);
    for (const Face& other : scene.faces) {
      const bool same_side = dot(face.plane.normal, other.plane.normal) > 0;
      Drawn outline = drawn(scene, scene.rings[other.first_ring], same_side, wall.axes);
      if (!same_side || !in_plane(wall.axes, other, outline, 1e-6)) continue;
      Shape shape = outline.region[0];
      for (uint64_t k = 1; k < other.ring_count; ++k) {
        Drawn hole = drawn(scene, scene.rings[other.first_ring + k], true, wall.axes);
        shape.rings.push_back(hole.region[0].rings[0]);
        find_head(hole);
        if (&other == &face) wall.openings.push_back(std::move(hole));
      }
      wall.region.push_back(std::move(shape));
      if (&other == &face) wall.outlines.push_back(std::move(outline));
    }
    out.push_back(std::move(wall));
  }
  return out;
}

inline bool is_opening_class(const std::string& name) { return part_class::is_opening(name); }

/// What a model has in the plane of a true wall: its faces there and the openings in them. Holes without a part count
/// as openings; so do openings at the wall's border, which have a face of their own behind it and no hole.
inline Wall modelled(const Model& model, const Wall& truth) {
  constexpr double kSamePlane_m = 0.04, kDeepest_m = 1.2;
  Wall out;
  out.axes = truth.axes;
  std::vector<bool> has_ring(model.parts.size(), false);
  for (const Ring& ring : model.rings)
    if (ring.part != kNoPart) has_ring[ring.part] = true;
  for (const Face& face : model.faces) {
    const bool same_side = dot(out.axes.n, face.plane.normal) > 0;
    Drawn outline = drawn(model, model.rings[face.first_ring], same_side, out.axes);
    const Part& part = model.parts[face.part];
    const bool is_pane =
        is_opening_class(part.part_class) ||
        (part.parent != kNoParent && is_opening_class(model.parts[part.parent].part_class));
    if (is_pane) {
      const auto owner =
          is_opening_class(part.part_class) ? face.part : static_cast<uint32_t>(part.parent);
      if (has_ring[owner] || !in_plane(out.axes, face, outline, kDeepest_m)) continue;
      has_ring[owner] = true;
      outline.part_class = model.parts[owner].part_class;
      outline.evidence = model.parts[owner].evidence;
      out.openings.push_back(std::move(outline));
      continue;
    }
    if (!in_plane(out.axes, face, outline, kSamePlane_m) || part.part_class == part_class::kNoData)
      continue;
    Shape shape = outline.region[0];
    for (uint64_t k = 1; k < face.ring_count; ++k) {
      const Ring& ring = model.rings[face.first_ring + k];
      Drawn hole = drawn(model, ring, same_side, out.axes);
      shape.rings.push_back(hole.region[0].rings[0]);
      hole.part_class = ring.part == kNoPart ? "" : model.parts[ring.part].part_class;
      if (ring.part != kNoPart) hole.evidence = model.parts[ring.part].evidence;
      if (ring.part == kNoPart || is_opening_class(hole.part_class))
        out.openings.push_back(std::move(hole));
    }
    out.region.push_back(std::move(shape));
    out.outlines.push_back(std::move(outline));
  }
  return out;
}

}  // namespace jalon::test
