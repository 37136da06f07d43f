// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/codes/curves.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace jalon {

namespace {

constexpr double kSagitta_m = 0.001;  // below the precision of a reflectorless point
constexpr int kMostChords = 256;
constexpr double kNearlyStraight = 1e-9;  // twice the triangle's area over its longest side squared

struct Arc {
  Vec2 centre;
  double radius_m, from_rad, turn_rad;
  Vec2 at(double t) const {
    const double angle = from_rad + t * turn_rad;
    return {centre.u + radius_m * std::cos(angle), centre.v + radius_m * std::sin(angle)};
  }
};

// The part from a to b of the circle through a, b and another point, on the side where that point is not.
std::optional<Arc> arc_between(const Vec2& a, const Vec2& b, const Vec2& beyond) {
  const Vec2 p = b - a, q = beyond - a;
  const double twice_area = cross(p, q);
  if (std::fabs(twice_area) <= kNearlyStraight * (dot(p, p) + dot(q, q))) return std::nullopt;
  const Vec2 to_centre{(q.v * dot(p, p) - p.v * dot(q, q)) / (2 * twice_area),
                       (p.u * dot(q, q) - q.u * dot(p, p)) / (2 * twice_area)};
  Arc arc{a + to_centre, norm(to_centre), std::atan2(-to_centre.v, -to_centre.u), 0};
  const Vec2 end = b - arc.centre;
  double turn = std::atan2(end.v, end.u) - arc.from_rad;
  // Counter-clockwise from a over b to the other point when the triangle turns left.
  if (twice_area > 0 && turn < 0) turn += 2 * std::numbers::pi;
  if (twice_area < 0 && turn > 0) turn -= 2 * std::numbers::pi;
  arc.turn_rad = turn;
  return arc;
}

int chords_of(const std::optional<Arc>& arc) {
  if (!arc) return 1;
  const double cosine = 1 - std::min(1.0, kSagitta_m / arc->radius_m);
  const double step = 2 * std::acos(cosine);
  return std::clamp(static_cast<int>(std::ceil(std::fabs(arc->turn_rad) / step)), 1, kMostChords);
}

// Inner points of the span from b to c; a and d are their neighbours along the bend, where there are any.
void add_span(const Vec2* a, const Vec2& b, const Vec2& c, const Vec2* d, std::vector<Vec2>& line) {
  std::optional<Arc> before, after;
  if (a != nullptr) before = arc_between(b, c, *a);
  if (d != nullptr) after = arc_between(b, c, *d);
  const int chords = std::max(chords_of(before), chords_of(after));
  for (int i = 1; i < chords; ++i) {
    const double t = static_cast<double>(i) / chords;
    const Vec2 straight = b + (c - b) * t;
    const Vec2 p = before ? before->at(t) : after && a == nullptr ? after->at(t) : straight;
    const Vec2 q = after ? after->at(t) : before && d == nullptr ? before->at(t) : straight;
    line.push_back(p * (1 - t) + q * t);
  }
}

}  // namespace

std::vector<Vec2> linkage_line(std::span<const LinkagePoint> points, bool is_closed) {
  const size_t n = points.size(), spans = is_closed ? n : n - std::min<size_t>(n, 1);
  std::vector<Vec2> line;
  for (size_t i = 0; i < n; ++i) {
    line.push_back(points[i].at);
    if (i >= spans) break;
    const LinkagePoint &b = points[i], &c = points[(i + 1) % n];
    if (!b.on_curve && !c.on_curve) continue;
    // A neighbour counts as part of the bend only beyond a point that lies on it.
    const Vec2* a = b.on_curve && (is_closed || i > 0) ? &points[(i + n - 1) % n].at : nullptr;
    const Vec2* d = c.on_curve && (is_closed || i + 2 < n) ? &points[(i + 2) % n].at : nullptr;
    add_span(a, b.at, c.at, d, line);
  }
  return line;
}

}  // namespace jalon
