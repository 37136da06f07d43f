// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include "base/random.h"
#include "modelling/edges/adjust/edge_blocks.h"

// Edges with the points of their solid beside them, in blocks as collect_blocks leaves them.
namespace edge_points {

using namespace jalon;

constexpr double kSpacing_m = 0.01;
constexpr double kBlock_m = 8 * kSpacing_m;

/// blocks in a row; fill(block) gives the depths of its points.
template <class F>
void add_blocks(MeasuredEdge& edge, size_t blocks, F&& fill) {
  for (size_t b = 0; b < blocks; ++b) {
    EdgeBlock block;
    block.length_m = kBlock_m;
    block.t_m = kSpacing_m + (static_cast<double>(b) + 0.5) * kBlock_m;
    block.depth_m = kStripInward * kSpacing_m;
    block.outward_m = kStripOutward * kSpacing_m;
    fill(block);
    std::sort(block.points.begin(), block.points.end(),
              [](const StripPoint& a, const StripPoint& b2) { return a.d_m < b2.d_m; });
    edge.blocks.push_back(std::move(block));
  }
}

/// Points at random, one a squared spacing, in the solid that begins at this depth (of t).
template <class F>
void add_random_blocks(MeasuredEdge& edge, size_t blocks, RandomStream& random, F&& begin_m) {
  add_blocks(edge, blocks, [&](EdgeBlock& block) {
    const double low = -kStripOutward * kSpacing_m, high = kStripInward * kSpacing_m;
    const auto n = static_cast<int>((high - low) * kBlock_m / (kSpacing_m * kSpacing_m));
    for (int i = 0; i < n; ++i) {
      const double t = block.t_m + kBlock_m * (random.uniform() - 0.5),
                   d = low + (high - low) * random.uniform();
      if (d > begin_m(t)) block.points.push_back({d, 1});
    }
  });
}

/// An edge that has room for so many blocks, from (0, 0) on.
inline MeasuredEdge edge_along(const Vec2& direction, size_t blocks) {
  MeasuredEdge out;
  const double length = kBlock_m * static_cast<double>(blocks) + 2 * kSpacing_m;
  out.shape = straight_shape({0, 0}, direction * length);
  return out;
}

}  // namespace edge_points
