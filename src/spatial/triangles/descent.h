// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Descent of the triangle tree towards a point. Everything is in an unnamed namespace: see triangle_closest.h.

#include "spatial/triangles/nodes.h"

#if defined(__SSE2__)
#include <immintrin.h>
#endif

namespace jalon {
namespace {

using triangle_tree::Float4;
using triangle_tree::kStackSize;
using triangle_tree::kWidth;
using triangle_tree::Node;

// Share by which a squared distance to a box may come out too large: five roundings of a float, doubled.
constexpr float kRounding = 1 + 0x1p-20f;
constexpr float kLeast = 0x1p-120f;  // more than any rounding of squares that underflow

/// A point in floats, not above and not below the true one.
struct FloatPoint {
  float below[3], above[3];

  explicit FloatPoint(const double* p) {
    for (int i = 0; i < 3; ++i) {
      const auto f = static_cast<float>(p[i]);
      const float step = __builtin_fabsf(f) * 0x1p-23f + kLeast;  // two roundings of f
      below[i] = f - step;
      above[i] = f + step;
    }
  }
};

#if defined(__SSE2__)
inline Float4 larger(Float4 a, Float4 b) { return _mm_max_ps(a, b); }
inline uint32_t less_equal(Float4 a, Float4 b) {
  return static_cast<uint32_t>(_mm_movemask_ps(_mm_cmple_ps(a, b)));
}
#else
inline Float4 larger(Float4 a, Float4 b) { return a > b ? a : b; }
inline uint32_t less_equal(Float4 a, Float4 b) {
  uint32_t mask = 0;
  for (uint32_t i = 0; i < kWidth; ++i) mask |= (a[i] <= b[i] ? 1u : 0u) << i;
  return mask;
}
#endif

/// Squared distances of the four boxes, not above the true ones by more than kRounding. Empty boxes: infinity.
[[gnu::always_inline]] inline Float4 box_distances(const Node& node, const FloatPoint& p) {
  const Float4 zero = {0, 0, 0, 0};
  const Float4 x = larger(larger(node.bounds[0] - p.above[0], p.below[0] - node.bounds[1]), zero);
  const Float4 y = larger(larger(node.bounds[2] - p.above[1], p.below[1] - node.bounds[3]), zero);
  const Float4 z = larger(larger(node.bounds[4] - p.above[2], p.below[2] - node.bounds[5]), zero);
  return x * x + y * y + z * z;
}

/// A box still to be visited.
struct PendingBox {
  float squared;
  uint32_t child, count;
  uint32_t place;  ///< 4 x node + child
};
constexpr uint32_t kAtRoot = ~uint32_t{0};

/// A float that no squared distance of a box up to the limit exceeds.
inline float box_limit(double squared) {
  return static_cast<float>(squared) * (kRounding * kRounding) + kLeast;
}

/// leaf(child) for the leaves whose box is no farther than limit, the nearest first; it gives the new limit. Boxes at
/// a place of which passes(place) is true are left out with all below them.
template <class F, class Passes>
[[gnu::always_inline]] inline void descend(const Node* nodes, const double* p, double limit2,
                                           F&& leaf, Passes&& passes) {
  const FloatPoint point(p);
  PendingBox stack[kStackSize];
  size_t size = 0;
  stack[size++] = {0, 0, 0, kAtRoot};
  float limit = box_limit(limit2);
  while (size > 0) {
    const PendingBox top = stack[--size];
    if (!(top.squared <= limit) || (top.place != kAtRoot && passes(top.place))) continue;
    if (top.count > 0) {
      limit = box_limit(leaf(top.child));
      continue;
    }
    const Node& node = nodes[top.child];
    const Float4 squared = box_distances(node, point);
    const Float4 limits = {limit, limit, limit, limit};
    const size_t first = size;  // sorted in, the nearest on top
    for (uint32_t met = less_equal(squared, limits); met != 0; met &= met - 1) {
      const auto i = static_cast<uint32_t>(__builtin_ctz(met));
      if (node.count[i] == 0 && node.child[i] == 0) continue;  // unused
      const uint32_t place = kWidth * top.child + i;
      if (passes(place)) continue;
      size_t at = size++;
      for (; at > first && stack[at - 1].squared < squared[i]; --at) stack[at] = stack[at - 1];
      stack[at] = {squared[i], node.child[i], node.count[i], place};
    }
  }
}

}  // namespace
}  // namespace jalon
