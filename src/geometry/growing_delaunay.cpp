// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/growing_delaunay.h"

#include <algorithm>
#include <cstring>
#include <limits>

#include "base/error.h"
#include "base/numbers.h"

namespace jalon {

namespace {

// Differences of coordinates then are below 2^26, products below 2^52 and sums of two exact in doubles.
constexpr double kGrowingDelaunayMaxSteps = 0x1p26;
constexpr uint32_t kNone = 0xffffffffu;

constexpr size_t kLanes = 2;
using Doubles = double __attribute__((vector_size(8 * kLanes)));
using Mask = int64_t __attribute__((vector_size(8 * kLanes)));

// The cotangent of the angle under which a point left of ab sees it, as a fraction; products are exact in 128 bits.
struct Cotangent {
  int64_t dot, cross;  // cross > 0
  bool operator<(const Cotangent& b) const {
    return static_cast<__int128>(dot) * b.cross < static_cast<__int128>(b.dot) * cross;
  }
};

}  // namespace

void GrowingDelaunay::snap(std::span<const Vec2> points, double grid_m) {
  const size_t lanes = (points.size() + kLanes - 1) / kLanes * kLanes;
  x_.assign(lanes, kNaN);
  y_.assign(lanes, kNaN);
  Vec2 low = points[0];
  for (const Vec2& p : points) low = {std::min(low.u, p.u), std::min(low.v, p.v)};
  bool fits = true;
  const auto steps = [&](double offset) {
    const double number = offset / grid_m + 0.5;
    if (!(number < kGrowingDelaunayMaxSteps)) return fits = false, 0.0;  // also NaN
    return static_cast<double>(static_cast<int32_t>(number));
  };
  for (size_t i = 0; i < points.size(); ++i) {
    x_[i] = steps(points[i].u - low.u);
    y_[i] = steps(points[i].v - low.v);
  }
  if (!fits)
    fail(Status::kLimit,
         "the points of a triangulation lie too far apart for its grid, or are not finite");
}

int64_t GrowingDelaunay::turn(uint32_t a, uint32_t b, uint32_t c) const {
  return static_cast<int64_t>((x_[b] - x_[a]) * (y_[c] - y_[a]) -
                              (y_[b] - y_[a]) * (x_[c] - x_[a]));
}

uint32_t GrowingDelaunay::first_on_node(uint32_t i) const {
  for (uint32_t j = 0; j < i; ++j)
    if (x_[j] == x_[i] && y_[j] == y_[i]) return j;
  return i;
}

// The disc on the segment to it as diameter is empty, so that this edge is in every Delaunay triangulation.
uint32_t GrowingDelaunay::nearest_node(uint32_t centre) const {
  double least = std::numeric_limits<double>::infinity();
  uint32_t nearest = kNone;
  for (uint32_t i = 0; i < x_.size(); ++i) {
    const double dx = x_[i] - x_[centre], dy = y_[i] - y_[centre], squared = dx * dx + dy * dy;
    if (squared > 0 && squared < least) least = squared, nearest = i;
  }
  return nearest;
}

// Both terms of the quotient are exact and rounding keeps order, so that the least is among those that round to the
// least.
uint32_t GrowingDelaunay::apex(uint32_t a, uint32_t b) const {
  const Doubles infinity = Doubles{} + std::numeric_limits<double>::infinity();
  const Doubles ax = Doubles{} + x_[a], ay = Doubles{} + y_[a], bx = Doubles{} + x_[b],
                by = Doubles{} + y_[b];
  Doubles least = infinity;
  Mask where = {}, equal = {}, here = {0, 1};
  for (size_t i = 0; i < x_.size(); i += kLanes, here += kLanes) {
    Doubles x, y;
    std::memcpy(&x, &x_[i], sizeof x);
    std::memcpy(&y, &y_[i], sizeof y);
    const Doubles ux = ax - x, uy = ay - y, vx = bx - x, vy = by - y;
    const Doubles cross = ux * vy - uy * vx;
    const Doubles cotangent = cross > 0 ? (ux * vx + uy * vy) / cross : infinity;
    const Mask less = cotangent < least;
    equal = less ? Mask{} : equal | (cotangent == least);
    where = less ? here : where;
    least = less ? cotangent : least;
  }
  size_t lane = 0;
  bool unique = true;
  for (size_t i = 1; i < kLanes; ++i) {
    if (least[i] == least[lane]) unique = false;
    if (least[i] < least[lane]) lane = i, unique = true;
  }
  if (least[lane] == infinity[0]) return kNone;
  return unique && equal[lane] == 0 ? static_cast<uint32_t>(where[lane])
                                    : apex_among_equal(a, b, least[lane]);
}

// Of the points that see ab under the largest angle, which then lie on one circle, the one that the fan about the first
// of them and of a and b takes.
uint32_t GrowingDelaunay::apex_among_equal(uint32_t a, uint32_t b, double least) const {
  std::vector<uint32_t> equal;
  Cotangent largest_angle{};
  for (uint32_t i = 0; i < x_.size(); ++i) {
    const double ux = x_[a] - x_[i], uy = y_[a] - y_[i], vx = x_[b] - x_[i], vy = y_[b] - y_[i];
    const double dot = ux * vx + uy * vy, cross = ux * vy - uy * vx;
    if (!(cross > 0 && dot / cross == least)) continue;
    const Cotangent cotangent{static_cast<int64_t>(dot), static_cast<int64_t>(cross)};
    if (!equal.empty() && largest_angle < cotangent) continue;
    if (equal.empty() || cotangent < largest_angle) equal.clear(), largest_angle = cotangent;
    if (first_on_node(i) == i) equal.push_back(i);
  }
  if (equal[0] < std::min(a, b)) return equal[0];
  const auto nearer_b = [&](uint32_t c, uint32_t d) { return turn(a, c, d) > 0; };
  return a < b ? *std::ranges::min_element(equal, nearer_b)
               : *std::ranges::max_element(equal, nearer_b);
}

void GrowingDelaunay::start(std::span<const Vec2> points, double grid_m, uint32_t centre) {
  triangles_.clear();
  border_.clear();
  snap(points, grid_m);
  centre = first_on_node(centre);
  const uint32_t first = nearest_node(centre);
  if (first == kNone) return;
  // 1. Anticlockwise about the centre, until all round or on the hull.
  for (uint32_t from = first, to; (to = apex(centre, from)) != kNone; from = to) {
    triangles_.push_back({centre, from, to});
    border_.push_back({from, to});
    if (to == first) return;
  }
  // 2. From the first edge clockwise to the hull on the other side.
  for (uint32_t to = first, from; (from = apex(to, centre)) != kNone; to = from) {
    triangles_.push_back({centre, from, to});
    border_.push_back({from, to});
  }
}

// An edge with triangles on both sides is no border.
void GrowingDelaunay::toggle(Edge edge) {
  const auto other = std::ranges::find(border_, Edge{edge.to, edge.from});
  if (other == border_.end()) return border_.push_back(edge);
  *other = border_.back();
  border_.pop_back();
}

bool GrowingDelaunay::grow(size_t edge) {
  const Edge across = border_[edge];
  border_[edge] = border_.back();
  border_.pop_back();
  const uint32_t top = apex(across.to, across.from);
  if (top == kNone) return false;
  triangles_.push_back({across.to, across.from, top});
  toggle({across.from, top});
  toggle({top, across.to});
  return true;
}

}  // namespace jalon
