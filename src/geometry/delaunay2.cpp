// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/delaunay2.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/serial.h"

namespace jalon {

namespace {

/// With coordinates in [0, 2^30) an orientation fits 62 bits and an in-circle determinant 124.
constexpr double kDelaunay2MaxSteps = 0x1p30;
/// Sub-problems of about this size ask whether to stop: a few milliseconds apart.
constexpr size_t kCheckpointNodes = 2048;
constexpr uint32_t kEdgesPerLook = 1 << 16;

struct Node {
  int64_t x, y;
};

/// Twice the signed area of abc: positive when anticlockwise.
int64_t turn(const Node& a, const Node& b, const Node& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Is d strictly inside the circle through the anticlockwise a, b, c?
bool in_circle(const Node& a, const Node& b, const Node& c, const Node& d) {
  const int64_t ax = a.x - d.x, ay = a.y - d.y, bx = b.x - d.x, by = b.y - d.y, cx = c.x - d.x,
                cy = c.y - d.y;
  const __int128 sum = static_cast<__int128>(ax * ax + ay * ay) * (bx * cy - cx * by) +
                       static_cast<__int128>(bx * bx + by * by) * (cx * ay - ax * cy) +
                       static_cast<__int128>(cx * cx + cy * cy) * (ax * by - bx * ay);
  return sum > 0;
}

/// Directed edges in pairs e, e ^ 1 of opposite directions; next and previous edge anticlockwise about the origin.
struct Edge {
  uint32_t origin, next, previous;
};

}  // namespace

struct Delaunay::Impl {
  std::vector<Node> nodes;                          // distinct, sorted by x then y
  std::vector<uint32_t> sources;                    // node -> first point on it
  std::vector<std::pair<uint64_t, uint32_t>> keys;  // (x, y) packed, point
  std::vector<Edge> edges;
  std::vector<uint32_t> free_edges;
  std::vector<std::array<uint32_t, 3>> triangles;
  Task* task = nullptr;

  struct Hull {
    uint32_t left,
        right;  ///< anticlockwise hull edge out of the leftmost node, clockwise one out of the rightmost
  };

  static uint32_t reverse(uint32_t e) { return e ^ 1; }
  uint32_t origin(uint32_t e) const { return edges[e].origin; }
  uint32_t target(uint32_t e) const { return edges[e ^ 1].origin; }
  uint32_t onext(uint32_t e) const { return edges[e].next; }
  uint32_t oprev(uint32_t e) const { return edges[e].previous; }
  uint32_t lnext(uint32_t e) const {
    return oprev(e ^ 1);
  }  // next anticlockwise about the left face
  uint32_t rprev(uint32_t e) const { return onext(e ^ 1); }
  bool is_left(uint32_t node, uint32_t e) const {
    return turn(nodes[node], nodes[origin(e)], nodes[target(e)]) > 0;
  }
  bool is_right(uint32_t node, uint32_t e) const {
    return turn(nodes[node], nodes[target(e)], nodes[origin(e)]) > 0;
  }
  bool circle(uint32_t a, uint32_t b, uint32_t c, uint32_t d) const {
    return in_circle(nodes[a], nodes[b], nodes[c], nodes[d]);
  }

  uint32_t make_edge(uint32_t from, uint32_t to) {
    uint32_t e;
    if (free_edges.empty()) {
      e = static_cast<uint32_t>(edges.size());
      edges.resize(edges.size() + 2);
    } else {
      e = free_edges.back();
      free_edges.pop_back();
    }
    edges[e] = {from, e, e};
    edges[e + 1] = {to, e + 1, e + 1};
    return e;
  }
  void splice(uint32_t a, uint32_t b) {
    const uint32_t a_next = onext(a), b_next = onext(b);
    edges[a].next = b_next;
    edges[b_next].previous = a;
    edges[b].next = a_next;
    edges[a_next].previous = b;
  }
  /// New edge from the target of a to the origin of b, with the same left face.
  uint32_t connect(uint32_t a, uint32_t b) {
    const uint32_t e = make_edge(target(a), origin(b));
    splice(e, lnext(a));
    splice(reverse(e), b);
    return e;
  }
  void remove(uint32_t e) {
    splice(e, oprev(e));
    splice(reverse(e), oprev(reverse(e)));
    edges[e & ~1u].origin = edges[e | 1u].origin = kDead;
    free_edges.push_back(e & ~1u);
  }

  void snap(std::span<const Vec2> points, double grid_m);
  Hull triangulate(size_t first, size_t count);
  Hull of_three(size_t first);
  uint32_t lower_tangent(Hull& left, Hull& right, uint32_t& inner_left, uint32_t& inner_right);
  void sew(uint32_t base);
  void collect();

  static constexpr uint32_t kDead = 0xffffffffu;
};

void Delaunay::Impl::snap(std::span<const Vec2> points, double grid_m) {
  nodes.clear();
  sources.clear();
  keys.clear();
  if (points.empty()) return;
  if (points.size() >= kDead / 6)
    fail(Status::kLimit, "too many points (%zu) for one triangulation", points.size());
  Vec2 low = points[0];
  for (const Vec2& p : points) low = {std::min(low.u, p.u), std::min(low.v, p.v)};
  const auto steps = [&](double offset) {
    const double number = offset / grid_m + 0.5;
    if (!(number < kDelaunay2MaxSteps))  // also NaN
      fail(Status::kLimit,
           "the points of a triangulation lie too far apart for its grid, or are not finite");
    return static_cast<uint64_t>(number);
  };
  keys.resize(points.size());
  for (size_t i = 0; i < points.size(); ++i) {
    if (task != nullptr && i % kEdgesPerLook == 0) task->checkpoint(0);
    keys[i] = {steps(points[i].u - low.u) << 32 | steps(points[i].v - low.v),
               static_cast<uint32_t>(i)};
  }
  if (task != nullptr) serial_sort(*task, keys.begin(), keys.end());
  else std::sort(keys.begin(), keys.end());
  for (size_t i = 0; i < keys.size(); ++i) {
    if (task != nullptr && i % kEdgesPerLook == 0) task->checkpoint(0);
    if (i > 0 && keys[i].first == keys[i - 1].first) continue;
    nodes.push_back({static_cast<int64_t>(keys[i].first >> 32),
                     static_cast<int64_t>(keys[i].first & 0xffffffffu)});
    sources.push_back(keys[i].second);
  }
}

Delaunay::Impl::Hull Delaunay::Impl::of_three(size_t first) {
  const auto i = static_cast<uint32_t>(first);
  const uint32_t a = make_edge(i, i + 1), b = make_edge(i + 1, i + 2);
  splice(reverse(a), b);
  const int64_t side = turn(nodes[i], nodes[i + 1], nodes[i + 2]);
  if (side == 0) return {a, reverse(b)};
  const uint32_t c = connect(b, a);
  if (side > 0) return {a, reverse(b)};
  return {reverse(c), c};
}

/// Lowest common tangent of the two halves; inner_left and inner_right are moved to it.
uint32_t Delaunay::Impl::lower_tangent(Hull& left, Hull& right, uint32_t& inner_left,
                                       uint32_t& inner_right) {
  for (;;) {
    if (is_left(origin(inner_right), inner_left)) inner_left = lnext(inner_left);
    else if (is_right(origin(inner_left), inner_right)) inner_right = rprev(inner_right);
    else break;
  }
  const uint32_t base = connect(reverse(inner_right), inner_left);
  if (origin(inner_left) == origin(left.left)) left.left = reverse(base);
  if (origin(inner_right) == origin(right.right)) right.right = base;
  return base;
}

/// Raises the base edge from the lower to the upper tangent; edges that fail the circle test go.
void Delaunay::Impl::sew(uint32_t base) {
  for (;;) {
    const auto above = [&](uint32_t e) { return is_right(target(e), base); };
    uint32_t left = onext(reverse(base));
    if (above(left))
      while (circle(target(base), origin(base), target(left), target(onext(left)))) {
        const uint32_t after = onext(left);
        remove(left);
        left = after;
      }
    uint32_t right = oprev(base);
    if (above(right))
      while (circle(target(base), origin(base), target(right), target(oprev(right)))) {
        const uint32_t after = oprev(right);
        remove(right);
        right = after;
      }
    const bool left_ok = above(left), right_ok = above(right);
    if (!left_ok && !right_ok) return;
    if (!left_ok || (right_ok && circle(target(left), origin(left), origin(right), target(right))))
      base = connect(right, reverse(base));
    else base = connect(reverse(base), reverse(left));
  }
}

Delaunay::Impl::Hull Delaunay::Impl::triangulate(size_t first, size_t count) {
  if (count == 2) {
    const uint32_t e = make_edge(static_cast<uint32_t>(first), static_cast<uint32_t>(first + 1));
    return {e, reverse(e)};
  }
  if (count == 3) return of_three(first);
  const size_t half = count / 2;
  Hull left = triangulate(first, half), right = triangulate(first + half, count - half);
  uint32_t inner_left = left.right, inner_right = right.left;
  sew(lower_tangent(left, right, inner_left, inner_right));
  if (task != nullptr && count >= kCheckpointNodes && count < 2 * kCheckpointNodes)
    task->checkpoint(static_cast<double>(first + count) / static_cast<double>(nodes.size()));
  return {left.left, right.right};
}

void Delaunay::Impl::collect() {
  for (uint32_t e = 0; e < edges.size(); ++e) {
    if (task != nullptr && e % kEdgesPerLook == 0) task->checkpoint(0);
    if (origin(e) == kDead) continue;
    const uint32_t f = lnext(e), g = lnext(f);
    if (f < e || g < e || lnext(g) != e) continue;
    const uint32_t a = origin(e), b = origin(f), c = origin(g);
    if (turn(nodes[a], nodes[b], nodes[c]) > 0)
      triangles.push_back({sources[a], sources[b], sources[c]});
  }
}

Delaunay::Delaunay() : impl_(std::make_unique<Impl>()) {}
Delaunay::~Delaunay() = default;

std::span<const std::array<uint32_t, 3>> Delaunay::run(std::span<const Vec2> points, double grid_m,
                                                       Task* task) {
  Impl& d = *impl_;
  d.task = task;
  d.edges.clear();
  d.free_edges.clear();
  d.triangles.clear();
  d.snap(points, grid_m);
  if (d.nodes.size() < 3) return {};
  d.edges.reserve(6 * d.nodes.size());
  d.triangulate(0, d.nodes.size());
  d.collect();
  return d.triangles;
}

std::vector<std::array<uint32_t, 3>> delaunay(std::span<const Vec2> points, double grid_m,
                                              Task* task) {
  Delaunay delaunay;
  const auto triangles = delaunay.run(points, grid_m, task);
  return {triangles.begin(), triangles.end()};
}

}  // namespace jalon
