// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/edges/adjust/edge_blocks.h"

#include <algorithm>
#include <cmath>

namespace jalon {

namespace {

// In spacings. Next to its ends the other edge takes points away or adds some; a block holds about eight columns of
// points, enough for a density and short enough to part what differs along the edge.
constexpr double kEnd = 1, kBlock = 8;
constexpr double kEdgeBlocksMostBlocks = 256;
// Contour points further than this from the edge are another edge's; nearer ones are its own.
constexpr double kOwn = 1.6;
// Points of a reveal lie within this of the edge.
constexpr double kRevealReach = 2;

void box_of(const EdgeShape& shape, double t0, double t1, double outward_m, double inward_m,
            Vec2& low, Vec2& high) {
  low = {INFINITY, INFINITY};
  high = {-INFINITY, -INFINITY};
  constexpr int kSteps = 4;  // blocks are short: their arcs bulge by little
  const double bulge =
      shape.is_arc ? (t1 - t0) * (t1 - t0) / (8 * kSteps * kSteps * shape.circle.radius) : 0;
  for (int k = 0; k <= kSteps; ++k)
    for (const double d : {-outward_m - bulge, inward_m + bulge}) {
      const Vec2 p = shape.at(t0 + (t1 - t0) * k / kSteps, d);
      low = {std::min(low.u, p.u), std::min(low.v, p.v)};
      high = {std::max(high.u, p.u), std::max(high.v, p.v)};
    }
}

// f(index, t, d) for the points with t0 <= t < t1 in the strip.
template <class F>
void visit_strip(const PointRows& points, const EdgeShape& shape, double t0, double t1,
                 double outward_m, double inward_m, F&& f) {
  Vec2 low, high;
  box_of(shape, t0, t1, outward_m, inward_m, low, high);
  points.visit(low, high, [&](uint32_t i) {
    const Vec2 at = shape.local(points.points[i]);
    if (at.u >= t0 && at.u < t1 && at.v >= -outward_m && at.v <= inward_m) f(i, at.u, at.v);
  });
}

}  // namespace

PointRows contour_points(std::span<const std::vector<Vec2>> rings, double spacing_m, Task& task) {
  PointRows out;
  for (const auto& ring : rings) out.points.insert(out.points.end(), ring.begin(), ring.end());
  out.sort(kStripInward * spacing_m, task);
  return out;
}

void collect_blocks(const NearPoints& near, const PointRows& contours, double spacing_m,
                    double min_height_m, MeasuredEdge& edge) {
  edge.blocks.clear();
  edge.behind.clear();
  edge.before.clear();
  const EdgeShape& shape = edge.shape;
  const double p = spacing_m, length = shape.length_m - 2 * kEnd * p;
  if (!(length >= p)) return;
  const double outward = kStripOutward * p, inward = kStripInward * p;
  const auto count = static_cast<size_t>(
      std::clamp(std::floor(length / (kBlock * p)), 1.0, kEdgeBlocksMostBlocks));
  const double step = length / static_cast<double>(count);
  for (size_t k = 0; k < count; ++k) {
    EdgeBlock block;
    const double t0 = kEnd * p + step * static_cast<double>(k), t1 = t0 + step;
    block.t_m = (t0 + t1) / 2;
    block.length_m = step;
    block.depth_m = inward;
    block.outward_m = outward;
    if (shape.is_arc && shape.turn > 0) block.depth_m = std::min(inward, 0.7 * shape.circle.radius);
    visit_strip(contours, shape, t0, t1, outward, inward + p, [&](uint32_t, double, double d) {
      if (d > kOwn * p) block.depth_m = std::min(block.depth_m, d - p);
      if (d < -kOwn * p) block.outward_m = std::min(block.outward_m, -d - p / 2);
    });
    visit_strip(near, shape, t0, t1, outward, inward, [&](uint32_t i, double t, double d) {
      const double height = near.heights_m[i];
      if (near.on_plane[i] != 0) block.points.push_back({d, 1 / shape.widening(d)});
      else if (std::fabs(height) >= min_height_m && std::fabs(d) <= kRevealReach * p)
        (height < 0 ? edge.behind : edge.before).push_back({t, d, height});
    });
    std::sort(block.points.begin(), block.points.end(),
              [](const StripPoint& a, const StripPoint& b) { return a.d_m < b.d_m; });
    edge.blocks.push_back(std::move(block));
  }
}

}  // namespace jalon
