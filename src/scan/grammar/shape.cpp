// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "scan/grammar/shape.h"

#include <algorithm>
#include <cmath>

namespace jalon::grammar {

namespace {

/// Height of a pointed arch over its springing, whose arcs have this radius, over this width.
double pointed_height(double radius_m, double width_m) {
  const double aside = radius_m - width_m / 2;
  return std::sqrt(std::max(0.0, radius_m * radius_m - aside * aside));
}

double arch_radius(const Shape& shape) {
  const double half = shape.rect.width() / 2;
  return (half * half + shape.rise_m * shape.rise_m) / (2 * shape.rise_m);
}

/// Rise of an arc over its chord.
double sagitta_of(double radius_m, double chord_m) {
  return radius_m - std::sqrt(std::max(0.0, radius_m * radius_m - chord_m * chord_m / 4));
}

Contour pointed_contour(const Rect& r) {
  const double springing = r.v1 - pointed_height(r.width(), r.width()), middle = (r.u0 + r.u1) / 2;
  const double sagitta = sagitta_of(r.width(), std::hypot(r.width() / 2, r.v1 - springing));
  return {{{r.u0, r.v0}},
          {{r.u1, r.v0}},
          {{r.u1, springing}, sagitta},
          {{middle, r.v1}, sagitta},
          {{r.u0, springing}}};
}

Contour round_contour(const Rect& r) {
  const double radius = r.width() / 2, u = r.u0 + radius, v = r.v0 + radius;
  const double sagitta = radius * (1 - std::sqrt(0.5));
  return {{{u, r.v0}, sagitta}, {{r.u1, v}, sagitta}, {{u, r.v1}, sagitta}, {{r.u0, v}, sagitta}};
}

/// Each edge moved outward; neighbours meet anew.
Outline grown_polygon(const Outline& corners, double by_m) {
  const size_t n = corners.size();
  Outline out;
  for (size_t k = 0; k < n; ++k) {
    const Vec2 p = corners[k], before = p - corners[(k + n - 1) % n],
               after = corners[(k + 1) % n] - p;
    const double lb = norm(before), la = norm(after);
    const Vec2 a{before.v / lb, -before.u / lb}, b{after.v / la, -after.u / la};
    const double share = by_m / (1 + dot(a, b));
    out.push_back(p + (a + b) * share);
  }
  return out;
}

}  // namespace

Shape Shape::round(const Vec2& middle, double radius_m) {
  return {Form::kRound,
          {middle.u - radius_m, middle.u + radius_m, middle.v - radius_m, middle.v + radius_m},
          0,
          {}};
}

Contour contour_of(const Shape& shape) {
  const Rect& r = shape.rect;
  switch (shape.form) {
    case Shape::Form::kArched:
      return {{{r.u0, r.v0}},
              {{r.u1, r.v0}},
              {{r.u1, r.v1 - shape.rise_m}, shape.rise_m},
              {{r.u0, r.v1 - shape.rise_m}}};
    case Shape::Form::kPointed:
      return pointed_contour(r);
    case Shape::Form::kRound:
      return round_contour(r);
    case Shape::Form::kPolygon: {
      Contour out;
      for (const Vec2& p : shape.corners) out.push_back({p});
      return out;
    }
    default:
      return jalon::contour_of(r);
  }
}

Shape grown(const Shape& shape, double by_m, bool keeps_foot) {
  Shape out = shape;
  Rect& r = out.rect;
  r = {r.u0 - by_m, r.u1 + by_m, r.v0 - (keeps_foot ? 0 : by_m), r.v1 + by_m};
  if (shape.form == Shape::Form::kArched) {  // concentric
    const double radius = arch_radius(shape) + by_m;
    out.rise_m = sagitta_of(radius, r.width());
  } else if (shape.form == Shape::Form::kPointed) {
    // Made anew with the width as radius over the same springing: a little lower than the concentric one.
    const double springing = springing_of(shape);
    r.v1 = springing + pointed_height(r.width(), r.width());
  } else if (shape.form == Shape::Form::kPolygon) {
    out.corners = grown_polygon(shape.corners, by_m);
  }
  return out;
}

bool can_shrink(const Shape& shape, double by_m) {
  const Rect r = bounds_of(contour_of(shape));
  const double sides = shape.form == Shape::Form::kPolygon ? 6 : 3;  // acute corners need more
  return std::min(r.width(), r.height()) > sides * by_m;
}

double springing_of(const Shape& shape) {
  const Rect& r = shape.rect;
  switch (shape.form) {
    case Shape::Form::kArched:
      return r.v1 - shape.rise_m;
    case Shape::Form::kPointed:
      return r.v1 - pointed_height(r.width(), r.width());
    default:
      return r.v1;
  }
}

}  // namespace jalon::grammar
