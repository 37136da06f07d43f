// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "model/model.h"

// Whether a model is geometrically sound, by code of its own: it shares nothing with the modeller but Model itself.
namespace checks {

using P3 = std::array<double, 3>;
using P2 = std::array<double, 2>;

inline P3 minus(const P3& a, const P3& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
inline P3 times(const P3& a, const P3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline double inner(const P3& a, const P3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline double length(const P3& a) { return std::sqrt(inner(a, a)); }

/// Ring r in coordinates relative to a corner of the face.
inline std::vector<P3> ring_points(const jalon::Model& m, const jalon::Ring& ring,
                                   const P3& origin) {
  std::vector<P3> out;
  for (uint64_t c = ring.first; c < ring.first + ring.count; ++c) {
    const auto& v = m.vertices[m.corners[c]];
    out.push_back(minus({v.x, v.y, v.z}, origin));
  }
  return out;
}

inline P3 origin_of(const jalon::Model& m, const jalon::Face& f) {
  const auto& v = m.vertices[m.corners[m.rings[f.first_ring].first]];
  return {v.x, v.y, v.z};
}

/// Twice the area vector of a closed polygon (Newell).
inline P3 newell(const std::vector<P3>& p) {
  P3 sum{};
  for (size_t i = 0; i < p.size(); ++i) {
    const P3 c = times(p[i], p[(i + 1) % p.size()]);
    for (size_t k = 0; k < 3; ++k) sum[k] += c[k];
  }
  return sum;
}

/// Largest distance of the face's corners from the plane of its outline's area vector through the corners' mean.
inline double flatness(const jalon::Model& m, const jalon::Face& f) {
  const P3 origin = origin_of(m, f);
  std::vector<P3> all;
  P3 n{};
  for (uint64_t r = 0; r < f.ring_count; ++r) {
    const auto ring = ring_points(m, m.rings[f.first_ring + r], origin);
    if (r == 0) n = newell(ring);
    all.insert(all.end(), ring.begin(), ring.end());
  }
  const double size = length(n);
  if (!(size > 0)) return INFINITY;
  double sum = 0, low = INFINITY, high = -INFINITY;
  for (const P3& p : all) {
    const double d = inner(p, n) / size;
    sum += d;
    low = std::min(low, d);
    high = std::max(high, d);
  }
  const double mean = sum / static_cast<double>(all.size());
  return std::max(high - mean, mean - low);
}

/// Rings of a face in 2D about its stated normal, arcs as 24 chords each.
inline std::vector<std::vector<P2>> flat_rings(const jalon::Model& m, const jalon::Face& f) {
  const P3 n{f.plane.normal.x, f.plane.normal.y, f.plane.normal.z};
  P3 u = std::fabs(n[2]) < 0.9 ? P3{-n[1], n[0], 0} : P3{n[2], 0, -n[0]};
  const double size = length(u);
  for (double& x : u) x /= size;
  const P3 v = times(n, u), origin = origin_of(m, f);
  std::vector<std::vector<P2>> out;
  for (uint64_t r = 0; r < f.ring_count; ++r) {
    const jalon::Ring& ring = m.rings[f.first_ring + r];
    const auto points = ring_points(m, ring, origin);
    auto& flat = out.emplace_back();
    for (size_t i = 0; i < points.size(); ++i) {
      const P3 &p = points[i], &q = points[(i + 1) % points.size()];
      const P2 a{inner(p, u), inner(p, v)}, b{inner(q, u), inner(q, v)};
      flat.push_back(a);
      const double s = m.sagittas.empty() ? 0 : m.sagittas[ring.first + i];
      if (s == 0) continue;
      // The circle through a, b and the point s to the right of the chord's middle.
      const double du = b[0] - a[0], dv = b[1] - a[1], c = std::hypot(du, dv);
      const double radius = (c * c / 4 + s * s) / (2 * std::fabs(s)), side = s > 0 ? 1 : -1;
      const double ou = (a[0] + b[0]) / 2 + side * dv / c * (std::fabs(s) - radius);
      const double ov = (a[1] + b[1]) / 2 - side * du / c * (std::fabs(s) - radius);
      const double whole = 4 * std::atan2(2 * std::fabs(s), c) * side,
                   start = std::atan2(a[1] - ov, a[0] - ou);
      for (int k = 1; k < 24; ++k)
        flat.push_back({ou + radius * std::cos(start + whole * k / 24),
                        ov + radius * std::sin(start + whole * k / 24)});
    }
  }
  return out;
}

inline double turn(const P2& a, const P2& b, const P2& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}
inline bool between(const P2& a, const P2& b, const P2& p) {
  return std::min(a[0], b[0]) <= p[0] && p[0] <= std::max(a[0], b[0]) &&
         std::min(a[1], b[1]) <= p[1] && p[1] <= std::max(a[1], b[1]);
}
/// Closed segments cross or touch.
inline bool meet(const P2& a, const P2& b, const P2& c, const P2& d) {
  const double t1 = turn(a, b, c), t2 = turn(a, b, d), t3 = turn(c, d, a), t4 = turn(c, d, b);
  if (((t1 > 0 && t2 < 0) || (t1 < 0 && t2 > 0)) && ((t3 > 0 && t4 < 0) || (t3 < 0 && t4 > 0)))
    return true;
  return (t1 == 0 && between(a, b, c)) || (t2 == 0 && between(a, b, d)) ||
         (t3 == 0 && between(c, d, a)) || (t4 == 0 && between(c, d, b));
}

inline bool holds(const std::vector<P2>& ring, const P2& p) {
  bool inside = false;
  for (size_t i = 0; i < ring.size(); ++i) {
    const P2 &a = ring[i], &b = ring[(i + 1) % ring.size()];
    if ((a[1] > p[1]) != (b[1] > p[1]) &&
        p[0] < a[0] + (b[0] - a[0]) * (p[1] - a[1]) / (b[1] - a[1]))
      inside = !inside;
  }
  return inside;
}

inline double area(const std::vector<P2>& ring) {
  double sum = 0;
  for (size_t i = 0; i < ring.size(); ++i) {
    const P2 &a = ring[i], &b = ring[(i + 1) % ring.size()];
    sum += a[0] * b[1] - b[0] * a[1];
  }
  return sum / 2;
}

/// What is wrong with the rings of a face: "" when the outline is simple and anticlockwise, the openings are simple and
/// clockwise, inside it and apart.
inline std::string ring_fault(const jalon::Model& m, const jalon::Face& f) {
  const auto rings = flat_rings(m, f);
  for (size_t r = 0; r < rings.size(); ++r) {
    const auto& ring = rings[r];
    const size_t n = ring.size();
    if (n < 3) return "ring of less than three corners";
    if ((area(ring) > 0) != (r == 0)) return "ring runs the wrong way round";
    for (size_t i = 0; i < n; ++i)
      for (size_t j = i + 1; j < n; ++j) {
        if (ring[i] == ring[(i + 1) % n]) return "edge without length";
        if (j == i + 1 || (i == 0 && j == n - 1)) continue;
        if (meet(ring[i], ring[(i + 1) % n], ring[j], ring[(j + 1) % n]))
          return "ring meets itself";
      }
    for (size_t q = 0; q < r; ++q) {
      const auto& other = rings[q];
      for (size_t i = 0; i < n; ++i)
        for (size_t j = 0; j < other.size(); ++j)
          if (meet(ring[i], ring[(i + 1) % n], other[j], other[(j + 1) % other.size()]))
            return "rings meet";
      if (holds(other, ring[0]) != (q == 0))
        return q == 0 ? "opening outside its face" : "opening in an opening";
      if (q > 0 && holds(ring, other[0])) return "opening around an opening";
    }
  }
  return "";
}

/// What is wrong with a solid: "" when each of its edges is walked once each way and its volume is positive.
inline std::string solid_fault(const jalon::Model& m, const jalon::Solid& solid) {
  std::map<std::pair<uint32_t, uint32_t>, int> walks;
  double volume = 0;
  const auto& v0 = m.vertices[m.corners[m.rings[m.faces[solid.first_face].first_ring].first]];
  const P3 origin{v0.x, v0.y, v0.z};
  for (uint64_t k = 0; k < solid.face_count; ++k) {
    const jalon::Face& f = m.faces[solid.first_face + k];
    for (uint64_t r = 0; r < f.ring_count; ++r) {
      const jalon::Ring& ring = m.rings[f.first_ring + r];
      const auto points = ring_points(m, ring, origin);
      volume += inner(newell(points), points[0]) / 6;
      for (uint64_t c = 0; c < ring.count; ++c) {
        if (!m.sagittas.empty() && m.sagittas[ring.first + c] != 0) return "arc in a solid";
        ++walks[{m.corners[ring.first + c], m.corners[ring.first + (c + 1) % ring.count]}];
      }
    }
  }
  for (const auto& [edge, count] : walks) {
    const auto back = walks.find({edge.second, edge.first});
    if (count != 1 || back == walks.end() || back->second != 1)
      return "edge not shared by two faces";
  }
  return volume > 0 ? "" : "solid turned inside out";
}

}  // namespace checks
