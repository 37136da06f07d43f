// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/evidence/opening_shape.h"

#include <algorithm>
#include <cmath>

namespace jalon {

namespace {

constexpr double kLeastHead = 1e-3;  // of a trapezium, of its foot: below it is a triangle

// Radius of the arcs of an arch: both halves have their centres at the springing line.
double arch_radius(double width, double rise) { return (width * width / 4 + rise * rise) / width; }
double segment_radius(double width, double rise) {
  return (width * width / 4 + rise * rise) / (2 * rise);
}

// Half the width of an arch at a height above its springing line.
double half_arch(double width, double rise, double height) {
  if (rise <= width / 2) {  // a segment of one circle, below or at the semicircle
    const double radius = segment_radius(width, rise), below = radius - rise;
    return std::sqrt(std::max(0.0, radius * radius - (height + below) * (height + below)));
  }
  const double radius = arch_radius(width, rise);
  return width / 2 - radius + std::sqrt(std::max(0.0, radius * radius - height * height));
}

VectorEdge edge_between(const Vec2& a, const Vec2& b, double sagitta_m = 0) {
  VectorEdge edge;
  edge.sagitta_m = sagitta_m;
  if (sagitta_m != 0) edge.direction = EdgeDirection::kArc;
  else if (a.u == b.u) edge.direction = EdgeDirection::kVertical;
  else if (a.v == b.v) edge.direction = EdgeDirection::kHorizontal;
  return edge;
}

// Corners with the sagitta of the edge after each; positive: bulges outward of an anticlockwise ring.
struct Corner {
  Vec2 at;
  double bulge = 0;
};

VectorRing ring_of(const std::vector<Corner>& corners) {
  VectorRing ring;
  for (size_t i = 0; i < corners.size(); ++i) {
    ring.corners.push_back(corners[i].at);
    ring.edges.push_back(
        edge_between(corners[i].at, corners[(i + 1) % corners.size()].at, corners[i].bulge));
  }
  return ring;
}

}  // namespace

size_t OpeningShape::size_count() const {
  switch (kind) {
    case ShapeKind::kRectangle:
      return 4;
    case ShapeKind::kTrapezium:
      return 6;
    case ShapeKind::kCircle:
      return 3;
    case ShapeKind::kTriangle:
    case ShapeKind::kGable:
    case ShapeKind::kArch:
      break;
  }
  return 5;
}

bool OpeningShape::is_valid() const {
  const auto& s = sizes;
  if (kind == ShapeKind::kCircle) return s[2] > 0;
  const double width = s[1] - s[0], height = s[3] - s[2];
  if (!(width > 0) || !(height > 0)) return false;
  switch (kind) {
    case ShapeKind::kTrapezium:
      return s[5] - s[4] > kLeastHead * width;
    case ShapeKind::kTriangle:
      return s[4] >= s[0] && s[4] <= s[1];
    case ShapeKind::kGable:
    case ShapeKind::kArch:
      return s[4] > 0 && s[4] <= height && s[4] <= 2 * width;
    default:
      return true;
  }
}

RingBox OpeningShape::box() const {
  const auto& s = sizes;
  RingBox out;
  if (kind == ShapeKind::kCircle) {
    out.add(Vec2{s[0] - s[2], s[1] - s[2]});
    out.add(Vec2{s[0] + s[2], s[1] + s[2]});
    return out;
  }
  out.add(Vec2{s[0], s[2]});
  out.add(Vec2{s[1], s[3]});
  if (kind == ShapeKind::kTrapezium) {
    out.add(Vec2{s[4], s[3]});
    out.add(Vec2{s[5], s[3]});
  }
  return out;
}

Vec2 OpeningShape::span_at(double v) const {
  const auto& s = sizes;
  switch (kind) {
    case ShapeKind::kRectangle:
      break;
    case ShapeKind::kTrapezium: {
      const double t = (v - s[2]) / (s[3] - s[2]);
      return {s[0] + (s[4] - s[0]) * t, s[1] + (s[5] - s[1]) * t};
    }
    case ShapeKind::kTriangle: {
      const double t = (v - s[2]) / (s[3] - s[2]);
      return {s[0] + (s[4] - s[0]) * t, s[1] + (s[4] - s[1]) * t};
    }
    case ShapeKind::kGable:
    case ShapeKind::kArch: {
      const double above = v - (s[3] - s[4]), width = s[1] - s[0], middle = (s[0] + s[1]) / 2;
      if (above <= 0) break;
      const double half = kind == ShapeKind::kGable ? width / 2 * (1 - above / s[4])
                                                    : half_arch(width, s[4], above);
      return {middle - half, middle + half};
    }
    case ShapeKind::kCircle: {
      const double half = std::sqrt(std::max(0.0, s[2] * s[2] - (v - s[1]) * (v - s[1])));
      return {s[0] - half, s[0] + half};
    }
  }
  return {s[0], s[1]};
}

OpeningShape OpeningShape::placed(double scale, const Vec2& by) const {
  OpeningShape out = *this;
  const auto u = [&](size_t i) { out.sizes[i] = sizes[i] * scale + by.u; };
  const auto v = [&](size_t i) { out.sizes[i] = sizes[i] * scale + by.v; };
  if (kind == ShapeKind::kCircle) {
    u(0), v(1);
    out.sizes[2] = sizes[2] * scale;
    return out;
  }
  u(0), u(1), v(2), v(3);
  if (kind == ShapeKind::kTrapezium) u(4), u(5);
  if (kind == ShapeKind::kTriangle) u(4);
  if (kind == ShapeKind::kGable || kind == ShapeKind::kArch) out.sizes[4] = sizes[4] * scale;
  return out;
}

OpeningShape OpeningShape::grown(double by) const {
  const auto& s = sizes;
  const double width = s[1] - s[0], height = s[3] - s[2];
  OpeningShape out = *this;
  if (kind == ShapeKind::kCircle) {
    out.sizes[2] += by;
    return out;
  }
  out.sizes[0] -= by, out.sizes[1] += by, out.sizes[2] -= by, out.sizes[3] += by;
  const double wider = width + 2 * by;
  if (kind == ShapeKind::kTrapezium || kind == ShapeKind::kTriangle) {
    const bool is_pointed = kind == ShapeKind::kTriangle;
    const double left = (s[4] - s[0]) / height, right = (s[is_pointed ? 4 : 5] - s[1]) / height;
    const double by_left = by * std::hypot(1, left), by_right = by * std::hypot(1, right);
    out.sizes[0] = s[0] - by_left - by * left;
    out.sizes[1] = s[1] + by_right - by * right;
    if (is_pointed) {  // where both sides meet
      const double rise = height * (1 + (by_left + by_right) / width);
      out.sizes[3] = s[2] + rise;
      out.sizes[4] = s[0] - by_left + left * rise;
    } else {
      out.sizes[4] = s[4] - by_left + by * left;
      out.sizes[5] = s[5] + by_right + by * right;
    }
  } else if (kind == ShapeKind::kArch && s[4] > width / 2) {  // both arcs about their centres
    const double radius = arch_radius(width, s[4]) + by;
    out.sizes[4] = std::sqrt(std::max(0.0, radius * wider - wider * wider / 4));
    out.sizes[3] = s[3] - s[4] + out.sizes[4];
  } else if (kind == ShapeKind::kGable || kind == ShapeKind::kArch) {
    // Slopes keep their angle, arcs up to a semicircle their centre's height in rise.
    out.sizes[4] = s[4] * wider / width;
    if (kind == ShapeKind::kGable) out.sizes[3] = s[3] + by * std::hypot(1, 2 * s[4] / width);
  }
  return out;
}

VectorRing OpeningShape::ring() const {
  const auto& s = sizes;
  const double middle = (s[0] + s[1]) / 2, springing = s[3] - s[4];
  switch (kind) {
    case ShapeKind::kRectangle:
      break;
    case ShapeKind::kTrapezium:
      return ring_of({{{s[0], s[2]}}, {{s[1], s[2]}}, {{s[5], s[3]}}, {{s[4], s[3]}}});
    case ShapeKind::kTriangle:
      return ring_of({{{s[0], s[2]}}, {{s[1], s[2]}}, {{s[4], s[3]}}});
    case ShapeKind::kGable:
      return ring_of({{{s[0], s[2]}},
                      {{s[1], s[2]}},
                      {{s[1], springing}},
                      {{middle, s[3]}},
                      {{s[0], springing}}});
    case ShapeKind::kArch: {
      const double width = s[1] - s[0];
      std::vector<Corner> corners{{{s[0], s[2]}}, {{s[1], s[2]}}};
      const bool has_jambs = springing > s[2];
      if (!has_jambs) corners.pop_back();
      if (s[4] <= width / 2) {
        corners.push_back({{s[1], springing}, s[4]});
        if (has_jambs) corners.push_back({{s[0], springing}});
      } else {
        const double radius = arch_radius(width, s[4]);
        const double chord = std::hypot(width / 2, s[4]);
        const double bulge = radius - std::sqrt(std::max(0.0, radius * radius - chord * chord / 4));
        corners.push_back({{s[1], springing}, bulge});
        corners.push_back({{middle, s[3]}, bulge});
        if (has_jambs) corners.push_back({{s[0], springing}});
      }
      return ring_of(corners);
    }
    case ShapeKind::kCircle: {  // rings have three corners at least
      const double bulge = s[2] * (1 - std::sqrt(0.5));
      return ring_of({{{s[0] - s[2], s[1]}, bulge},
                      {{s[0], s[1] - s[2]}, bulge},
                      {{s[0] + s[2], s[1]}, bulge},
                      {{s[0], s[1] + s[2]}, bulge}});
    }
  }
  return ring_of({{{s[0], s[2]}}, {{s[1], s[2]}}, {{s[1], s[3]}}, {{s[0], s[3]}}});
}

OpeningShape shape_in(ShapeKind kind, const RingBox& box) {
  OpeningShape out{kind, {box.low.u, box.high.u, box.low.v, box.high.v, 0, 0}};
  const double width = box.width(), height = box.height();
  switch (kind) {
    case ShapeKind::kRectangle:
      break;
    case ShapeKind::kTrapezium:
      out.sizes[4] = box.low.u + width / 8;
      out.sizes[5] = box.high.u - width / 8;
      break;
    case ShapeKind::kTriangle:
      out.sizes[4] = box.middle().u;
      break;
    case ShapeKind::kGable:
    case ShapeKind::kArch:
      out.sizes[4] = std::min(width / 2, height / 2);
      break;
    case ShapeKind::kCircle:
      out.sizes = {box.middle().u, box.middle().v, (width + height) / 4, 0, 0, 0};
      break;
  }
  return out;
}

}  // namespace jalon
