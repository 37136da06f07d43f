// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/edges/join/ring_nodes.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "geometry/polygon2.h"

namespace jalon {

namespace {

// Neighbouring lines flatter than this to each other have no useful intersection.
constexpr double kLeastSine = 0.1;
// Chords of an arc this near to it decide whether a ring crosses itself, in spacings.
constexpr double kRingNodesChordError = 0.05;

// Ends of neighbours nearer to each other than this are one node, in spacings; of arcs that go on each other more.
constexpr double kStep = 0.1, kArcStep = 0.5;

double squared(const Vec2& d) { return dot(d, d); }

const Vec2& nearer(const Vec2& a, const Vec2& b, const Vec2& to) {
  return squared(b - to) < squared(a - to) ? b : a;
}

// H is the foot of the centre on the line; two points at +- h from it, or H itself at tangency.
std::optional<Vec2> meet_circle(const EdgeLine& line, const Circle& circle, double tolerance_m,
                                const Vec2& near) {
  const Vec2 foot = line.foot(circle.centre);
  const double distance = norm(foot - circle.centre);
  if (distance > circle.radius + tolerance_m) return std::nullopt;
  const double h = std::sqrt(std::max(0.0, circle.radius * circle.radius - distance * distance));
  Vec2 out = nearer(foot + line.direction * h, foot - line.direction * h, near);
  if (line.direction.u == 0) out.u = line.point.u;
  if (line.direction.v == 0) out.v = line.point.v;
  return out;
}

std::optional<Vec2> meet_circles(const Circle& a, const Circle& b, double tolerance_m,
                                 const Vec2& near) {
  const Vec2 apart = b.centre - a.centre;
  const double d = norm(apart);
  if (!(d > 0) || d > a.radius + b.radius + tolerance_m) return std::nullopt;
  if (d < std::fabs(a.radius - b.radius) - tolerance_m) return std::nullopt;
  const double along = (d * d + a.radius * a.radius - b.radius * b.radius) / (2 * d);
  const double h = std::sqrt(std::max(0.0, a.radius * a.radius - along * along));
  const Vec2 unit = apart * (1 / d), foot = a.centre + unit * along,
             across{-unit.v * h, unit.u * h};
  return nearer(foot + across, foot - across, near);
}

// Of two places that nearest to `near`.
std::optional<Vec2> meet(const EdgeShape& a, const EdgeShape& b, double tolerance_m,
                         const Vec2& near) {
  if (a.is_arc && b.is_arc) return meet_circles(a.circle, b.circle, tolerance_m, near);
  if (a.is_arc) return meet_circle(b.line, a.circle, tolerance_m, near);
  if (b.is_arc) return meet_circle(a.line, b.circle, tolerance_m, near);
  return intersect(a.line, b.line, kLeastSine);
}

// Two arcs of one circle.
bool go_on(const EdgeShape& a, const EdgeShape& b, double tolerance_m) {
  return a.is_arc && b.is_arc && a.turn == b.turn &&
         norm(a.circle.centre - b.circle.centre) <= tolerance_m &&
         std::fabs(a.circle.radius - b.circle.radius) <= tolerance_m;
}

Vec2 foot_on(const EdgeShape& shape, const Vec2& p) {
  if (!shape.is_arc) return shape.line.foot(p);
  const Vec2 d = p - shape.circle.centre;
  return shape.circle.centre + d * (shape.circle.radius / norm(d));
}

std::vector<Vec2> nodes_between(const EdgeShape& a, const EdgeShape& b, double spacing_m,
                                double reach_m) {
  const bool is_one_circle = go_on(a, b, spacing_m);
  std::optional<Vec2> node;
  if (!is_one_circle) node = meet(a, b, spacing_m, (a.last + b.first) * 0.5);
  if (node && std::min(norm(*node - a.last), norm(*node - b.first)) <= reach_m) return {*node};
  const Vec2 end = foot_on(a, a.last), start = foot_on(b, b.first);
  if (norm(end - start) <= (is_one_circle ? kArcStep : kStep) * spacing_m)
    return {(end + start) * 0.5};
  return {end, start};
}

VectorEdge edge_of(const EdgeShape& shape, const Vec2& from, const Vec2& to) {
  VectorEdge edge{0, shape.sigma_m, shape.direction, shape.source};
  if (!shape.is_arc) return edge;
  EdgeShape arc = shape;
  arc.set_ends(from, to);
  edge.sagitta_m =
      shape.turn * arc.circle.radius * (1 - std::cos(arc.length_m / (2 * arc.circle.radius)));
  return edge;
}

bool runs_forward(const EdgeShape& shape, const Vec2& from, const Vec2& to) {
  if (!shape.is_arc) return dot(shape.line.direction, to - from) > 0;
  EdgeShape arc = shape;
  arc.set_ends(from, to);
  // Of nodes in the wrong order the arc would run round the other way.
  return std::fabs(arc.length_m - shape.length_m) < shape.length_m / 2 + 0.1 * shape.circle.radius;
}

// A ring of two arcs, or of an arc and its chord, has no area by its corners alone: each arc becomes two.
void halve_arcs(VectorRing& ring, std::span<const EdgeShape> edges) {
  VectorRing out;
  for (size_t i = 0; i < ring.corners.size(); ++i) {
    const Vec2 from = ring.corners[i], to = ring.corners[(i + 1) % ring.corners.size()];
    out.corners.push_back(from);
    out.edges.push_back(ring.edges[i]);
    if (ring.edges[i].sagitta_m == 0) continue;
    EdgeShape arc = edges[i];
    arc.set_ends(from, to);
    const Vec2 middle = arc.circle.centre + arc.axis * arc.circle.radius;
    out.edges.back() = edge_of(arc, from, middle);
    out.corners.push_back(middle);
    out.edges.push_back(edge_of(arc, middle, to));
  }
  ring = std::move(out);
}

}  // namespace

std::optional<VectorRing> join_edges(std::span<const EdgeShape> edges, double spacing_m,
                                     double reach_m) {
  const size_t n = edges.size();
  if (n < 2) return std::nullopt;
  // 1. Nodes between edge i and the next: one, or two with a step between.
  std::vector<std::vector<Vec2>> nodes(n);
  for (size_t i = 0; i < n; ++i)
    nodes[i] = nodes_between(edges[i], edges[(i + 1) % n], spacing_m, reach_m);
  // 2. The ring.
  VectorRing out;
  for (size_t i = 0; i < n; ++i) {
    const Vec2 from = nodes[(i + n - 1) % n].back(), to = nodes[i].front();
    if (!runs_forward(edges[i], from, to)) return std::nullopt;
    out.corners.push_back(from);
    out.edges.push_back(edge_of(edges[i], from, to));
    if (nodes[i].size() == 1) continue;
    out.corners.push_back(to);
    out.edges.push_back({});
  }
  if (out.corners.size() == 2) halve_arcs(out, edges);
  const auto flat = flattened(out, kRingNodesChordError * spacing_m);
  if (flat.size() < 3 || !is_simple(flat)) return std::nullopt;
  return out;
}

}  // namespace jalon
