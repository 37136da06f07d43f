// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "report/elevation/drawn_ring.h"

#include <cmath>
#include <numbers>

#include "formats/drawings/svg_writer.h"
#include "model/topology.h"
#include "report/elevation/face_rings.h"

namespace jalon {

namespace {

// A circle in a plane with this normal, looked at along y: its short half axis lies where the normal leans.
DrawnArc drawn_arc(const Vec2& a, const Vec2& b, double sagitta_m, const Vec3& normal) {
  DrawnArc out;
  const Arc2 arc = arc_of(a, b, sagitta_m);
  out.radius_m = arc.radius;
  out.flat_m = arc.radius * std::fabs(normal.y);
  out.flat_direction_rad = std::atan2(normal.z, normal.x);
  out.is_large = std::fabs(arc.bulge) > 1;
  out.is_anticlockwise =
      (sagitta_m > 0) == (normal.y < 0);  // seen against a normal that points at the eye
  return out;
}

void append_number(std::string& d, double value) {
  d += svg_number(value);
  d += ' ';
}

void append_corner(std::string& d, char command, const Vec2& p) {
  d += command;
  append_number(d, p.u);
  d += svg_number(p.v);
}

// SVG 2, 9.3.8: radii, rotation (clockwise on the page), large-arc, sweep (1: clockwise on the page), end point.
void append_arc_command(std::string& d, const DrawnArc& arc, const Vec2& to, double mm_per_m) {
  d += 'A';
  append_number(d, arc.flat_m * mm_per_m);
  append_number(d, arc.radius_m * mm_per_m);
  append_number(d, -arc.flat_direction_rad * 180 / std::numbers::pi);
  d += arc.is_large ? "1 " : "0 ";
  d += arc.is_anticlockwise ? "0 " : "1 ";
  append_number(d, to.u);
  d += svg_number(to.v);
}

void append_ring(std::string& d, const DrawnRing& ring, const OnPaper& on_paper) {
  if (ring.corners.empty()) return;
  append_corner(d, 'M', on_paper(ring.corners.front()));
  for (size_t i = 0; i < ring.corners.size(); ++i) {
    const size_t next = (i + 1) % ring.corners.size();
    const Vec2 to = on_paper(ring.corners[next]);
    if (!ring.arcs.empty() && ring.arcs[i].radius_m > 0)
      append_arc_command(d, ring.arcs[i], to, on_paper.mm_per_m);
    else if (next != 0) append_corner(d, 'L', to);
  }
  d += 'Z';
}

}  // namespace

DrawnRing drawn_ring(const Model& model, const Face& face, uint64_t ring,
                     const ElevationView& view) {
  DrawnRing out;
  out.ring = ring;
  const Ring& from = model.rings[ring];
  const auto seen = [&](const Vec3& p) {
    const Vec3 q = view(p);
    return Vec2{q.x, q.z};
  };
  for (uint64_t i = 0; i < from.count; ++i)
    out.corners.push_back(seen(model.vertices[model.corners[from.first + i]]));
  if (!has_arc(model, from)) {
    out.polygon = out.corners;
    return out;
  }
  const PlaneFrame frame = frame_of(model, face);
  const Vec3 normal = view.T_view_world.direction(face.plane.normal);
  for (const Vec2& p : ring_polygon(model, from, frame)) out.polygon.push_back(seen(frame.lift(p)));
  for (uint64_t i = 0; i < from.count; ++i) {
    const double sagitta = model.sagitta(from.first + i);
    const Vec2 a = frame.project(model.vertices[model.corners[from.first + i]]);
    const Vec2 b = frame.project(model.vertices[model.corners[from.first + (i + 1) % from.count]]);
    out.arcs.push_back(sagitta != 0 && !(a == b) ? drawn_arc(a, b, sagitta, normal) : DrawnArc{});
  }
  return out;
}

std::string svg_path(const DrawnRing& ring, const OnPaper& on_paper) {
  std::string d;
  append_ring(d, ring, on_paper);
  return d;
}

std::string svg_path(const std::vector<DrawnRing>& rings, const OnPaper& on_paper) {
  std::string d;
  for (const DrawnRing& ring : rings) append_ring(d, ring, on_paper);
  return d;
}

}  // namespace jalon
