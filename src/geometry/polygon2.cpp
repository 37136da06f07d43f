// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/polygon2.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace jalon {

namespace {

double turn(const Vec2& a, const Vec2& b, const Vec2& c) { return cross(b - a, c - a); }

bool on_segment(const Vec2& p, const Vec2& a, const Vec2& b) {
  return turn(a, b, p) == 0 && p.u >= std::min(a.u, b.u) && p.u <= std::max(a.u, b.u) &&
         p.v >= std::min(a.v, b.v) && p.v <= std::max(a.v, b.v);
}

/// Marks the corners strictly between first and last (indices modulo n) that the recursion keeps;
/// an explicit stack, so that long lines cannot overflow the machine's.
void keep_between(std::span<const Vec2> line, size_t first, size_t last, double tolerance,
                  std::vector<uint8_t>& keep) {
  std::vector<std::pair<size_t, size_t>> stack{{first, last}};
  while (!stack.empty()) {
    const auto [from, to] = stack.back();
    stack.pop_back();
    double worst = tolerance;
    size_t split = from;
    for (size_t i = from + 1; i < to; ++i) {
      const double d =
          segment_distance(line[i % line.size()], line[from % line.size()], line[to % line.size()]);
      if (d > worst) {
        worst = d;
        split = i;
      }
    }
    if (split == from) continue;
    keep[split % line.size()] = 1;
    stack.emplace_back(from, split);
    stack.emplace_back(split, to);
  }
}

}  // namespace

double signed_area(std::span<const Vec2> polygon) {
  double twice = 0;
  for (size_t i = 2; i < polygon.size(); ++i) twice += turn(polygon[0], polygon[i - 1], polygon[i]);
  return twice / 2;
}

double perimeter(std::span<const Vec2> polygon) {
  double sum = 0;
  for (size_t i = 0; i < polygon.size(); ++i)
    sum += norm(polygon[(i + 1) % polygon.size()] - polygon[i]);
  return sum;
}

bool contains(std::span<const Vec2> polygon, const Vec2& p) {
  bool inside = false;
  for (size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    const Vec2 &a = polygon[i], &b = polygon[j];
    if (on_segment(p, a, b)) return true;
    if ((a.v > p.v) == (b.v > p.v)) continue;
    // p is left of the border where the triangle (low end, high end, p) runs anticlockwise.
    const double side = a.v < b.v ? turn(a, b, p) : turn(b, a, p);
    if (side > 0) inside = !inside;
  }
  return inside;
}

double segment_distance(const Vec2& p, const Vec2& a, const Vec2& b) {
  const Vec2 d = b - a;
  const double length2 = dot(d, d);
  const double t = length2 > 0 ? std::clamp(dot(p - a, d) / length2, 0.0, 1.0) : 0.0;
  return norm(p - (a + d * t));
}

double border_distance(std::span<const Vec2> polygon, const Vec2& p) {
  double best = std::numeric_limits<double>::infinity();
  for (size_t i = 0; i < polygon.size(); ++i)
    best = std::min(best, segment_distance(p, polygon[i], polygon[(i + 1) % polygon.size()]));
  return best;
}

std::vector<uint32_t> simplified(std::span<const Vec2> line, double tolerance, bool is_closed) {
  const size_t n = line.size();
  std::vector<uint8_t> keep(n, n <= 2 ? 1 : 0);
  if (n > 2) {
    keep[0] = 1;
    if (is_closed) {
      size_t far = 0;
      for (size_t i = 1; i < n; ++i)
        if (norm(line[i] - line[0]) > norm(line[far] - line[0])) far = i;
      keep[far] = 1;
      keep_between(line, 0, far, tolerance, keep);
      keep_between(line, far, n, tolerance, keep);
    } else {
      keep[n - 1] = 1;
      keep_between(line, 0, n - 1, tolerance, keep);
    }
  }
  std::vector<uint32_t> kept;
  for (size_t i = 0; i < n; ++i)
    if (keep[i]) kept.push_back(static_cast<uint32_t>(i));
  return kept;
}

std::vector<uint32_t> convex_hull(std::span<const Vec2> points) {
  std::vector<uint32_t> order(points.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(), [&](uint32_t a, uint32_t b) {
    const Vec2 &p = points[a], &q = points[b];
    return p.u != q.u ? p.u < q.u : p.v != q.v ? p.v < q.v : a < b;
  });
  order.erase(std::unique(order.begin(), order.end(),
                          [&](uint32_t a, uint32_t b) { return points[a] == points[b]; }),
              order.end());
  if (order.size() < 3) return order;
  std::vector<uint32_t> hull;
  const auto extend = [&](uint32_t i, size_t floor) {
    while (hull.size() >= floor + 2 &&
           turn(points[hull[hull.size() - 2]], points[hull.back()], points[i]) <= 0)
      hull.pop_back();
    hull.push_back(i);
  };
  for (uint32_t i : order) extend(i, 0);
  const size_t lower = hull.size() - 1;
  for (size_t k = order.size() - 1; k-- > 0;) extend(order[k], lower);
  hull.pop_back();
  return hull;
}

bool segments_meet(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  const double abc = turn(a, b, c), abd = turn(a, b, d), cda = turn(c, d, a), cdb = turn(c, d, b);
  const auto opposite = [](double s, double t) { return (s > 0 && t < 0) || (s < 0 && t > 0); };
  if (opposite(abc, abd) && opposite(cda, cdb)) return true;
  return on_segment(c, a, b) || on_segment(d, a, b) || on_segment(a, c, d) || on_segment(b, c, d);
}

bool is_simple(std::span<const Vec2> polygon) {
  const size_t n = polygon.size();
  if (n < 3) return false;
  for (size_t i = 0; i < n; ++i) {
    const Vec2 &a = polygon[i], &b = polygon[(i + 1) % n];
    if (a == b) return false;
    // The neighbour must not fold back onto this side.
    const Vec2& next = polygon[(i + 2) % n];
    if (on_segment(next, a, b) || on_segment(a, b, next)) return false;
    for (size_t j = i + 2; j < n; ++j) {
      if (i == 0 && j == n - 1) continue;
      if (segments_meet(a, b, polygon[j], polygon[(j + 1) % n])) return false;
    }
  }
  return true;
}

}  // namespace jalon
