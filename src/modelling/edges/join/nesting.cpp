// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/edges/join/nesting.h"

#include <algorithm>
#include <cmath>

#include "geometry/polygon2.h"

namespace jalon {

namespace {

struct Box2 {
  Vec2 low{INFINITY, INFINITY}, high{-INFINITY, -INFINITY};
  void add(const Vec2& p) {
    low = {std::min(low.u, p.u), std::min(low.v, p.v)};
    high = {std::max(high.u, p.u), std::max(high.v, p.v)};
  }
  bool meets(const Box2& b) const {
    return low.u <= b.high.u && b.low.u <= high.u && low.v <= b.high.v && b.low.v <= high.v;
  }
};

Box2 box_of(const Polygon& polygon) {
  Box2 box;
  for (const Vec2& p : polygon) box.add(p);
  return box;
}

bool borders_meet(const Polygon& a, const Polygon& b) {
  const Box2 box_b = box_of(b);
  for (size_t i = 0; i < a.size(); ++i) {
    const Vec2 &p = a[i], &q = a[(i + 1) % a.size()];
    Box2 edge;
    edge.add(p);
    edge.add(q);
    if (!edge.meets(box_b)) continue;
    for (size_t j = 0; j < b.size(); ++j)
      if (segments_meet(p, q, b[j], b[(j + 1) % b.size()])) return true;
  }
  return false;
}

bool conflict(const Polygon& outline, const Polygon& opening, bool first_is_outline) {
  if (borders_meet(outline, opening)) return true;
  if (first_is_outline) return !contains(outline, opening.front());
  return contains(outline, opening.front()) || contains(opening, outline.front());
}

}  // namespace

std::vector<size_t> nested(std::span<const RingForms> rings) {
  std::vector<size_t> level(rings.size(), 0);
  const auto form = [&](size_t i) -> const Polygon& { return rings[i].flat[level[i]]; };
  const auto step_down = [&](size_t i) {
    if (level[i] + 1 >= rings[i].flat.size()) return false;
    ++level[i];
    return true;
  };
  // Each round lowers at least one ring, so it ends. The opening gives way first: the outline carries more.
  for (bool changed = true; changed;) {
    changed = false;
    for (size_t i = 0; i < rings.size(); ++i)
      for (size_t j = i + 1; j < rings.size(); ++j)
        while (conflict(form(i), form(j), i == 0)) {
          if (!step_down(j) && !step_down(i)) break;  // chains that touch in a point
          changed = true;
        }
  }
  return level;
}

}  // namespace jalon
