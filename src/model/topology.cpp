// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "model/topology.h"

#include <algorithm>
#include <cmath>

namespace jalon {

namespace {

struct Use {
  uint32_t from, to;
  double sagitta_m;
  uint32_t face;
};

std::vector<Use> ring_edges(const Model& model) {
  std::vector<Use> uses;
  uses.reserve(model.corners.size());
  for (size_t f = 0; f < model.faces.size(); ++f)
    for (uint64_t r = 0; r < model.faces[f].ring_count; ++r) {
      const Ring& ring = model.rings[model.faces[f].first_ring + r];
      for (uint64_t i = 0; i < ring.count; ++i) {
        const uint64_t here = ring.first + i, next = ring.first + (i + 1) % ring.count;
        const uint32_t a = model.corners[here], b = model.corners[next];
        const double s = model.sagitta(here);
        // Walked the other way an arc bulges to the other side.
        uses.push_back(a < b ? Use{a, b, s, static_cast<uint32_t>(f)}
                             : Use{b, a, -s, static_cast<uint32_t>(f)});
      }
    }
  return uses;
}

}  // namespace

std::vector<Edge> find_edges(const Model& model) {
  std::vector<Use> uses = ring_edges(model);
  std::stable_sort(uses.begin(), uses.end(), [](const Use& a, const Use& b) {
    return a.from != b.from ? a.from < b.from : a.to < b.to;
  });
  std::vector<Edge> edges;
  for (const Use& use : uses) {
    if (edges.empty() || edges.back().from != use.from || edges.back().to != use.to)
      edges.push_back({use.from, use.to, use.sagitta_m, use.face, kNoFace, 0});
    else if (edges.back().second_face == kNoFace) edges.back().second_face = use.face;
    ++edges.back().uses;
  }
  return edges;
}

Arc2 arc_of(const Vec2& a, const Vec2& b, double sagitta_m) {
  const Vec2 chord = b - a;
  const double c = norm(chord), s = std::fabs(sagitta_m);
  Arc2 arc;
  arc.bulge = 2 * sagitta_m / c;
  arc.radius = (c * c / 4 + s * s) / (2 * s);
  // To the right of the walk for a positive sagitta.
  const double side = sagitta_m > 0 ? 1 : -1;
  const Vec2 towards{side * chord.v / c, -side * chord.u / c};
  arc.centre = a + chord * 0.5 + towards * (s - arc.radius);
  return arc;
}

void append_arc(std::vector<Vec2>& out, const Vec2& a, const Vec2& b, double sagitta_m,
                double chord_error_m) {
  out.push_back(a);
  if (sagitta_m == 0 || !(norm(b - a) > 0)) return;
  const Arc2 arc = arc_of(a, b, sagitta_m);
  const double angle = 4 * std::atan(std::fabs(arc.bulge));
  const double step = 2 * std::acos(std::max(0.0, 1 - chord_error_m / arc.radius));
  const double wanted = step > 0 ? std::ceil(angle / step) : 1;
  constexpr double kMostChords = 4096;  // a guard against absurd errors, not a quality
  const auto count = static_cast<int>(std::clamp(wanted, 1.0, kMostChords));
  const Vec2 from = a - arc.centre;
  const double turn = (sagitta_m > 0 ? angle : -angle) / count;
  for (int k = 1; k < count; ++k) {
    const double c = std::cos(k * turn), s = std::sin(k * turn);
    out.push_back(arc.centre + Vec2{c * from.u - s * from.v, s * from.u + c * from.v});
  }
}

}  // namespace jalon
