// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "scan/builder/contour.h"

#include <algorithm>
#include <cmath>

#include "geometry/polygon2.h"
#include "model/topology.h"

namespace jalon {

namespace {

constexpr double kContourChord_m = 1e-4;  // of an arc from its chords, as in arched_outline
constexpr double kOnEdge_m = 1e-7;        // what is set on an edge lies on it but for rounding

double distance_from_line(const Vec2& p, const Vec2& a, const Vec2& b) {
  return std::fabs(cross(b - a, p - a)) / norm(b - a);
}

/// The straight edge of the opening that lies on the outline's edge from a to b, in its direction; -1 for none.
ptrdiff_t edge_on(const Vec2& a, const Vec2& b, const Contour& opening) {
  const Vec2 along = b - a;
  const double length = norm(along);
  for (size_t k = 0; k < opening.size(); ++k) {
    const Vec2 p = opening[k].at, q = opening[(k + 1) % opening.size()].at;
    if (opening[k].sagitta_m != 0 || dot(q - p, along) <= 0) continue;
    const double from = dot(p - a, along) / length, to = dot(q - a, along) / length;
    if (from >= -kOnEdge_m && to <= length + kOnEdge_m && distance_from_line(p, a, b) < kOnEdge_m &&
        distance_from_line(q, a, b) < kOnEdge_m)
      return static_cast<ptrdiff_t>(k);
  }
  return -1;
}

/// The walk round the opening from the start of its edge k to the end of it, the other way round.
void append_walk(const Contour& opening, size_t k, Contour& out) {
  const size_t n = opening.size();
  for (size_t step = 0; step + 1 < n; ++step) {
    const size_t from = (k + n - step) % n, before = (from + n - 1) % n;
    out.push_back({opening[from].at, -opening[before].sagitta_m});
  }
  out.push_back({opening[(k + 1) % n].at, 0});
}

}  // namespace

Contour contour_of(const Rect& r) {
  return {{{r.u0, r.v0}}, {{r.u1, r.v0}}, {{r.u1, r.v1}}, {{r.u0, r.v1}}};
}

Outline chords_of(const Contour& contour) {
  Outline out;
  for (size_t k = 0; k < contour.size(); ++k)
    append_arc(out, contour[k].at, contour[(k + 1) % contour.size()].at, contour[k].sagitta_m,
               kContourChord_m);
  return out;
}

Rect bounds_of(const Contour& contour) {
  Rect out{contour[0].at.u, contour[0].at.u, contour[0].at.v, contour[0].at.v};
  for (const Vec2& p : chords_of(contour))
    out = {std::min(out.u0, p.u), std::max(out.u1, p.u), std::min(out.v0, p.v),
           std::max(out.v1, p.v)};
  return out;
}

double area_of(const Contour& contour) { return signed_area(chords_of(contour)); }

bool touches_border(const Contour& outline, const Contour& opening) {
  for (size_t k = 0; k < outline.size(); ++k)
    if (outline[k].sagitta_m == 0 &&
        edge_on(outline[k].at, outline[(k + 1) % outline.size()].at, opening) >= 0)
      return true;
  return false;
}

Contour notched(const Contour& outline, const std::vector<Contour>& openings) {
  Contour out;
  for (size_t k = 0; k < outline.size(); ++k) {
    const Vec2 a = outline[k].at, b = outline[(k + 1) % outline.size()].at;
    struct Notch {
      double along;
      const Contour* opening;
      size_t edge;
    };
    std::vector<Notch> notches;
    if (outline[k].sagitta_m == 0)
      for (const Contour& opening : openings)
        if (const ptrdiff_t edge = edge_on(a, b, opening); edge >= 0)
          notches.push_back({dot(opening[static_cast<size_t>(edge)].at - a, b - a), &opening,
                             static_cast<size_t>(edge)});
    std::sort(notches.begin(), notches.end(),
              [](const Notch& x, const Notch& y) { return x.along < y.along; });
    out.push_back(outline[k]);
    for (const Notch& notch : notches) append_walk(*notch.opening, notch.edge, out);
  }
  return out;
}

void add_sides(SceneBuilder& out, uint32_t part, const Frame& frame, const Contour& contour,
               double low_m, double high_m, bool from_inside) {
  for (size_t k = 0; k < contour.size(); ++k) {
    const Vec2 a = contour[k].at, b = contour[(k + 1) % contour.size()].at;
    if (contour[k].sagitta_m != 0) {
      Outline path;
      append_arc(path, a, b, contour[k].sagitta_m, kContourChord_m);
      path.push_back(b);
      if (!from_inside) std::reverse(path.begin(), path.end());
      out.swept(frame, path, low_m, high_m);
      continue;
    }
    const double length = norm(b - a);
    const Vec3 n = frame.normal(), foot = frame.point(a.u, a.v, low_m),
               along = (frame.u * (b.u - a.u) + frame.v * (b.v - a.v)) / length;
    // n x along looks into the contour, along x n out of it.
    if (from_inside) out.face(part, {foot, n, along}, {0, high_m - low_m, 0, length});
    else out.face(part, {foot, along, n}, {0, length, 0, high_m - low_m});
  }
}

}  // namespace jalon
