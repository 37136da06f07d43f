// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/plane/ring_tools.h"

#include <algorithm>

#include "geometry/polygon2.h"
#include "model/topology.h"

namespace jalon {

namespace {

constexpr double kBoxChord_m = 1e-4;  // boxes of arcs: well below any spacing

bool borders_meet(std::span<const Vec2> a, std::span<const Vec2> b) {
  RingBox all;
  all.add(b);
  for (size_t i = 0; i < a.size(); ++i) {
    const Vec2 &p = a[i], &q = a[(i + 1) % a.size()];
    RingBox edge;
    edge.add(p);
    edge.add(q);
    if (!edge.meets(all)) continue;
    for (size_t j = 0; j < b.size(); ++j)
      if (segments_meet(p, q, b[j], b[(j + 1) % b.size()])) return true;
  }
  return false;
}

}  // namespace

void RingBox::add(const Vec2& p) {
  low = {std::min(low.u, p.u), std::min(low.v, p.v)};
  high = {std::max(high.u, p.u), std::max(high.v, p.v)};
}

void RingBox::add(std::span<const Vec2> points) {
  for (const Vec2& p : points) add(p);
}

void drop_short_edges(VectorRing& ring, double least_m) {
  for (size_t i = 0; i < ring.corners.size() && ring.corners.size() > 3;) {
    const size_t next = (i + 1) % ring.corners.size();
    if (ring.edges[i].sagitta_m != 0 || norm(ring.corners[next] - ring.corners[i]) >= least_m) {
      ++i;
      continue;
    }
    // Edge `next` now begins at corner i.
    ring.corners.erase(ring.corners.begin() + static_cast<ptrdiff_t>(next));
    ring.edges.erase(ring.edges.begin() + static_cast<ptrdiff_t>(i));
    if (next == 0) {  // the first corner went: its edge belongs to the last one
      std::rotate(ring.corners.begin(), ring.corners.end() - 1, ring.corners.end());
      break;
    }
  }
}

double overlap(const RingBox& a, const RingBox& b) {
  const double width = std::min(a.high.u, b.high.u) - std::max(a.low.u, b.low.u),
               height = std::min(a.high.v, b.high.v) - std::max(a.low.v, b.low.v);
  if (width <= 0 || height <= 0) return 0;
  const double both = width * height;
  return both / (a.width() * a.height() + b.width() * b.height() - both);
}

VectorRing reversed(const VectorRing& ring) {
  VectorRing out;
  const size_t n = ring.corners.size();
  out.corners.assign(ring.corners.rbegin(), ring.corners.rend());
  out.edges.reserve(n);
  // The edge that led into a corner now leaves it.
  for (size_t i = 0; i < n; ++i) {
    out.edges.push_back(ring.edges[(2 * n - 2 - i) % n]);
    out.edges.back().sagitta_m = -out.edges.back().sagitta_m;
  }
  return out;
}

VectorRing with_chords(const VectorRing& ring, double chord_error_m) {
  VectorRing out;
  const size_t n = ring.corners.size();
  for (size_t i = 0; i < n; ++i) {
    const Vec2 &a = ring.corners[i], &b = ring.corners[(i + 1) % n];
    // Always drawn from the lower end, so that neighbours on both sides of an arc get the same bits.
    const bool turn = a.u != b.u ? a.u > b.u : a.v > b.v;
    const double sagitta_m = ring.edges[i].sagitta_m;
    std::vector<Vec2> points;
    append_arc(points, turn ? b : a, turn ? a : b, turn ? -sagitta_m : sagitta_m, chord_error_m);
    if (turn) {
      std::reverse(points.begin() + 1, points.end());
      points.front() = a;
    }
    VectorEdge edge = ring.edges[i];
    edge.sagitta_m = 0;
    for (const Vec2& p : points) {
      out.corners.push_back(p);
      out.edges.push_back(edge);
    }
  }
  return out;
}

RingBox ring_box(const VectorRing& ring) {
  RingBox box;
  box.add(flattened(ring, kBoxChord_m));
  return box;
}

bool is_simple(const VectorRing& ring, double chord_error_m) {
  const std::vector<Vec2> polygon = flattened(ring, chord_error_m);
  const size_t n = polygon.size();
  if (n < 3) return false;
  for (size_t i = 0; i < n; ++i) {
    const Vec2 &a = polygon[i], &b = polygon[(i + 1) % n];
    if (a == b) return false;
    // The next edge may share the corner but not run back along this one.
    const Vec2 c = polygon[(i + 2) % n];
    if (cross(b - a, c - b) == 0 && dot(b - a, c - b) < 0) return false;
    const double low = std::min(a.u, b.u), high = std::max(a.u, b.u);
    for (size_t j = i + 2; j < n; ++j) {
      if (i == 0 && j == n - 1) continue;
      const Vec2 &p = polygon[j], &q = polygon[(j + 1) % n];
      if (std::max(p.u, q.u) < low || std::min(p.u, q.u) > high) continue;
      if (segments_meet(a, b, p, q)) return false;
    }
  }
  return true;
}

bool is_sound(const VectorFace& face, double chord_error_m) {
  if (!is_simple(face.outline, chord_error_m) || signed_area(face.outline) <= 0) return false;
  const std::vector<Vec2> outline = flattened(face.outline, chord_error_m);
  std::vector<std::vector<Vec2>> holes;
  std::vector<RingBox> boxes;
  for (const VectorRing& opening : face.openings) {
    if (!is_simple(opening, chord_error_m) || signed_area(opening) >= 0) return false;
    holes.push_back(flattened(opening, chord_error_m));
    boxes.emplace_back().add(holes.back());
    if (borders_meet(holes.back(), outline) || !contains(outline, holes.back().front()))
      return false;
    for (size_t k = 0; k + 1 < holes.size(); ++k) {
      if (!boxes[k].meets(boxes.back())) continue;
      if (borders_meet(holes[k], holes.back()) || contains(holes[k], holes.back().front()) ||
          contains(holes.back(), holes[k].front()))
        return false;
    }
  }
  return true;
}

}  // namespace jalon
