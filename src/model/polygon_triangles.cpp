// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "model/polygon_triangles.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace jalon {

namespace {

constexpr double kAreaShare = 1e-9;         // by which triangles may miss their polygon's area
constexpr double kApart = 1e-9;             // of the polygon's size, between rings that touch
constexpr size_t kMaxClippedCorners = 512;  // of a polygon in a mesh file; larger ones become fans

double turn(const Vec2& a, const Vec2& b, const Vec2& c) { return cross(b - a, c - a); }

double area2(const std::vector<Vec2>& ring) {
  double sum = 0;
  for (size_t i = 2; i < ring.size(); ++i) sum += turn(ring[0], ring[i - 1], ring[i]);
  return sum;
}

/// Twice the area of the outline without its openings.
double area2_of(const std::vector<std::vector<Vec2>>& rings) {
  double sum = 0;
  for (size_t r = 0; r < rings.size(); ++r) sum += (r == 0 ? 1 : -1) * std::fabs(area2(rings[r]));
  return sum;
}

/// Twice the area of triangles whose corners count through all rings; what lies the wrong way round counts too.
double covered2(const std::vector<std::vector<Vec2>>& rings,
                const std::vector<std::array<uint32_t, 3>>& triangles) {
  std::vector<Vec2> corners;
  for (const auto& ring : rings) corners.insert(corners.end(), ring.begin(), ring.end());
  double sum = 0;
  for (const auto& [a, b, c] : triangles)
    sum += std::fabs(turn(corners[a], corners[b], corners[c]));
  return sum;
}

/// The rings with every corner of an opening that lies on another ring's corner moved a little into its opening, so
/// that no two rings touch: a bridge could not tell the two sides of such a corner.
std::vector<std::vector<Vec2>> kept_apart(const std::vector<std::vector<Vec2>>& rings) {
  struct Place {
    Vec2 p;
    size_t ring, corner;
  };
  std::vector<Place> places;
  double size = 0;
  for (size_t r = 0; r < rings.size(); ++r)
    for (size_t i = 0; i < rings[r].size(); ++i) {
      places.push_back({rings[r][i], r, i});
      size = std::max(size, norm(rings[r][i] - rings[0][0]));
    }
  std::stable_sort(places.begin(), places.end(), [](const Place& a, const Place& b) {
    return a.p.u != b.p.u ? a.p.u < b.p.u : a.p.v < b.p.v;
  });
  auto out = rings;
  for (size_t k = 0; k < places.size(); ++k) {
    const Place& place = places[k];
    const bool as_before = k > 0 && places[k - 1].p == place.p;
    const bool as_after = k + 1 < places.size() && places[k + 1].p == place.p;
    if (place.ring == 0 || !(as_before || as_after)) continue;
    const std::vector<Vec2>& ring = rings[place.ring];
    const size_t n = ring.size();
    const Vec2 &before = ring[(place.corner + n - 1) % n], &after = ring[(place.corner + 1) % n];
    const Vec2 a = before - place.p, b = after - place.p;
    const Vec2 middle = a * (1 / std::max(norm(a), 1e-300)) + b * (1 / std::max(norm(b), 1e-300));
    const bool is_convex = (turn(before, place.p, after) > 0) == (area2(ring) > 0);
    out[place.ring][place.corner] = place.p + middle * ((is_convex ? kApart : -kApart) * size);
  }
  return out;
}

bool in_triangle(const Vec2& p, const Vec2& a, const Vec2& b, const Vec2& c) {
  return turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0;
}

/// A closed chain of corners from which ears are cut. Bridges make corners appear twice, so nodes
/// and vertices differ.
class Chain {
 public:
  explicit Chain(const std::vector<std::vector<Vec2>>& rings) {
    uint32_t first = 0;
    std::vector<uint32_t> starts;  // a node of each opening
    for (size_t r = 0; r < rings.size(); ++r) {
      for (const Vec2& p : rings[r]) vertices_.push_back(p);
      if (rings[r].size() >= 3) {
        const uint32_t node = add_ring(rings[r], first, (area2(rings[r]) > 0) == (r == 0));
        if (r == 0) start_ = node;
        else starts.push_back(rightmost(node));
      }
      if (r == 0 && rings[r].size() < 3) return;
      first += static_cast<uint32_t>(rings[r].size());
    }
    // From right to left, so that a bridge may end on an opening already joined.
    std::stable_sort(starts.begin(), starts.end(),
                     [&](uint32_t a, uint32_t b) { return at(a).u > at(b).u; });
    for (const uint32_t node : starts) join(node);
  }

  std::vector<std::array<uint32_t, 3>> cut() {
    std::vector<std::array<uint32_t, 3>> out;
    if (next_.empty()) return out;
    size_t left = mark_reflex();
    uint32_t node = start_;
    bool crossed = false, hopeless = false;
    for (size_t tried = 0; left > 3;) {
      // A polygon that crosses itself: from then on take what turns the right way, at last
      // anything.
      crossed = crossed || tried > left;
      hopeless = hopeless || tried > 2 * left;
      if (is_ear(node, crossed, hopeless)) {
        out.push_back(corners(node));
        node = remove(node);
        --left;
        tried = 0;
      } else {
        node = next_[node];
        ++tried;
      }
    }
    if (left == 3) out.push_back(corners(node));
    return out;
  }

 private:
  const Vec2& at(uint32_t node) const { return vertices_[vertex_[node]]; }

  uint32_t add_node(uint32_t vertex) {
    vertex_.push_back(vertex);
    next_.push_back(0);
    previous_.push_back(0);
    return static_cast<uint32_t>(vertex_.size() - 1);
  }
  void link(uint32_t a, uint32_t b) {
    next_[a] = b;
    previous_[b] = a;
  }

  uint32_t add_ring(const std::vector<Vec2>& ring, uint32_t first, bool forward) {
    const auto n = static_cast<uint32_t>(ring.size());
    const auto begin = static_cast<uint32_t>(vertex_.size());
    for (uint32_t i = 0; i < n; ++i) add_node(first + (forward ? i : n - 1 - i));
    for (uint32_t i = 0; i < n; ++i) link(begin + i, begin + (i + 1) % n);
    return begin;
  }

  uint32_t rightmost(uint32_t node) const {
    uint32_t best = node;
    for (uint32_t i = next_[node]; i != node; i = next_[i])
      if (at(i).u > at(best).u || (at(i).u == at(best).u && at(i).v < at(best).v)) best = i;
    return best;
  }

  // Joins the opening whose rightmost corner is `hole` to a corner of the chain that it sees.
  void join(uint32_t hole) {
    const uint32_t seen = visible_from(hole);
    const uint32_t after = next_[seen];
    const uint32_t hole_end = previous_[hole];
    const uint32_t hole_again = add_node(vertex_[hole]), seen_again = add_node(vertex_[seen]);
    link(seen, hole);
    link(hole_end, hole_again);
    link(hole_again, seen_again);
    link(seen_again, after);
  }

  uint32_t visible_from(uint32_t hole) const {
    const Vec2 m = at(hole);
    double nearest = std::numeric_limits<double>::infinity();
    uint32_t best = start_;
    bool found = false;
    uint32_t i = start_;
    do {  // the first edge that a ray to the right meets; the chain runs upwards there
      const Vec2 &a = at(i), &b = at(next_[i]);
      if (a.v <= m.v && b.v >= m.v && a.v != b.v) {
        const double u = a.u + (m.v - a.v) / (b.v - a.v) * (b.u - a.u);
        if (u >= m.u && u < nearest) {
          nearest = u;
          best = b.v == m.v ? next_[i] : a.v == m.v ? i : a.u > b.u ? i : next_[i];
          found = true;
        }
      }
      i = next_[i];
    } while (i != start_);
    if (!found) return start_;
    return unhidden(m, {nearest, m.v}, best);
  }

  // Corners inside the triangle of m, the hit and the candidate hide the candidate: the one nearest
  // in angle to the ray is seen.
  uint32_t unhidden(const Vec2& m, const Vec2& hit, uint32_t candidate) const {
    const Vec2 p = at(candidate);
    uint32_t best = candidate;
    double best_slope = std::numeric_limits<double>::infinity(), best_distance = best_slope;
    uint32_t i = start_;
    do {
      const Vec2& q = at(i);
      const bool inside = p.v < m.v ? in_triangle(q, m, p, hit) : in_triangle(q, m, hit, p);
      if (q.u > m.u && inside && opens_towards(i, m)) {
        const double slope = std::fabs(q.v - m.v) / (q.u - m.u), distance = q.u - m.u;
        if (slope < best_slope || (slope == best_slope && distance < best_distance)) {
          best = i;
          best_slope = slope;
          best_distance = distance;
        }
      }
      i = next_[i];
    } while (i != start_);
    return best;
  }

  // True when the direction to p lies inside the corner's angle: of the two nodes at a bridge only
  // one does.
  bool opens_towards(uint32_t node, const Vec2& p) const {
    const Vec2 &a = at(previous_[node]), &b = at(node), &c = at(next_[node]);
    if (turn(a, b, c) >= 0) return turn(b, c, p) >= 0 && turn(b, p, a) >= 0;
    return !(turn(b, a, p) > 0 && turn(b, p, c) > 0);
  }

  bool is_reflex(uint32_t node) const {
    return turn(at(previous_[node]), at(node), at(next_[node])) <= 0;
  }

  size_t mark_reflex() {
    size_t count = 0;
    uint32_t i = start_;
    do {
      if (is_reflex(i)) reflex_.push_back(i);
      ++count;
      i = next_[i];
    } while (i != start_);
    gone_.assign(next_.size(), 0);
    return count;
  }

  bool is_ear(uint32_t node, bool convex_is_enough, bool anything) const {
    if (anything) return true;
    const Vec2 &a = at(previous_[node]), &b = at(node), &c = at(next_[node]);
    if (turn(a, b, c) <= 0) return false;
    if (convex_is_enough) return true;
    for (const uint32_t i : reflex_) {
      if (gone_[i] || !is_reflex(i)) continue;
      const Vec2& p = at(i);
      if (p == a || p == b || p == c) continue;
      if (in_triangle(p, a, b, c)) return false;
    }
    return true;
  }

  uint32_t remove(uint32_t node) {
    const uint32_t after = next_[node];
    gone_[node] = 1;
    link(previous_[node], after);
    if (start_ == node) start_ = after;
    return next_[after];  // skipping one keeps the triangles from piling up in one corner
  }

  std::array<uint32_t, 3> corners(uint32_t node) const {
    return {vertex_[previous_[node]], vertex_[node], vertex_[next_[node]]};
  }

  std::vector<Vec2> vertices_;
  std::vector<uint32_t> vertex_, next_, previous_, reflex_;
  std::vector<uint8_t> gone_;
  uint32_t start_ = 0;
};

}  // namespace

std::vector<std::array<uint32_t, 3>> triangulate(const std::vector<std::vector<Vec2>>& rings) {
  // Openings that touch the outline or each other in a corner can lead a bridge astray, as can corners on nearly one
  // line. The triangles then cover more than the polygon: the rings are kept apart and other directions of the bridges
  // tried.
  if (rings.empty() || rings[0].size() < 3) return {};
  auto first = Chain(rings).cut();
  const double wanted = area2_of(rings),
               step = 2.399963229728653;  // the golden angle: no direction comes twice
  const auto fits = [&](const auto& triangles) {
    return std::fabs(covered2(rings, triangles) - wanted) <= kAreaShare * wanted;
  };
  if (fits(first)) return first;
  const auto apart = kept_apart(rings);
  constexpr int kDirections = 12;
  for (int k = 0; k < kDirections; ++k) {
    const double c = std::cos(k * step), s = std::sin(k * step);
    auto turned = apart;
    for (auto& ring : turned)
      for (Vec2& p : ring) p = {c * p.u - s * p.v, s * p.u + c * p.v};
    auto triangles = Chain(turned).cut();
    if (fits(triangles)) return triangles;
  }
  return first;
}

PlaneAxes axes_of(const Vec3& normal) {
  const Vec3 n = normalized(normal);
  const Vec3 help =
      std::fabs(n.x) < 0.6 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};  // any direction well off the normal
  const Vec3 v = normalized(cross(n, help));
  return {cross(v, n), v};
}

Vec3 newell_normal(std::span<const Vec3> corners) {
  Vec3 sum;
  for (size_t i = 2; i < corners.size(); ++i)
    sum += cross(corners[i - 1] - corners[0], corners[i] - corners[0]);
  return sum;
}

void append_polygon(Model& model, std::span<const uint32_t> corners, uint32_t face_id) {
  const auto add = [&](uint32_t a, uint32_t b, uint32_t c) {
    model.triangles.push_back({a, b, c});
    model.triangle_faces.push_back(face_id);
  };
  if (corners.size() > 3 && corners.size() <= kMaxClippedCorners) {
    std::vector<Vec3> points;
    for (const uint32_t corner : corners) points.push_back(model.vertices[corner]);
    const PlaneAxes axes = axes_of(newell_normal(points));
    std::vector<std::vector<Vec2>> rings(1);
    for (const Vec3& p : points) rings[0].push_back(axes.project(p, points[0]));
    for (const auto& t : triangulate(rings)) add(corners[t[0]], corners[t[1]], corners[t[2]]);
    return;
  }
  for (size_t i = 2; i < corners.size(); ++i) add(corners[0], corners[i - 1], corners[i]);
}

std::vector<std::array<uint32_t, 3>> triangles_of_face(const Model& model, const Face& face) {
  std::vector<std::vector<Vec2>> rings;
  std::vector<uint32_t> corners;
  std::vector<Vec3> outline;
  for (uint64_t r = face.first_ring; r < face.first_ring + face.ring_count; ++r) {
    const Ring& ring = model.rings[r];
    for (uint64_t c = ring.first; c < ring.first + ring.count; ++c) {
      corners.push_back(model.corners[c]);
      if (r == face.first_ring) outline.push_back(model.vertices[model.corners[c]]);
    }
  }
  if (outline.size() < 3) return {};
  // The stated normal, or that of the outline when there is none.
  const double length = norm(face.plane.normal);
  const PlaneAxes axes =
      axes_of(length > 0.5 && length < 2 ? face.plane.normal : newell_normal(outline));
  size_t at = 0;
  for (uint64_t r = face.first_ring; r < face.first_ring + face.ring_count; ++r) {
    rings.emplace_back();
    for (uint64_t c = 0; c < model.rings[r].count; ++c)
      rings.back().push_back(axes.project(model.vertices[corners[at++]], outline[0]));
  }
  std::vector<std::array<uint32_t, 3>> out = triangulate(rings);
  for (auto& triangle : out)
    for (uint32_t& corner : triangle) corner = corners[corner];
  return out;
}

std::vector<uint32_t> loose_triangles(const Model& model) {
  std::vector<uint32_t> ids, out;
  for (const Face& face : model.faces) ids.push_back(face.id);
  std::ranges::sort(ids);
  for (uint32_t t = 0; t < model.triangles.size(); ++t)
    if (!std::ranges::binary_search(ids, model.triangle_faces[t])) out.push_back(t);
  return out;
}

bool is_mesh_by_part(const Model& model) {
  return model.faces.empty() && !model.parts.empty() &&
         std::ranges::all_of(model.triangle_faces,
                             [&](uint32_t id) { return id < model.parts.size(); });
}

}  // namespace jalon
