// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/evaluation/border_distances.h"

#include <algorithm>
#include <cmath>

#include "geometry/polygon2.h"

namespace jalon {

namespace {

constexpr size_t kEdgesPerBlock = 16;
constexpr double kMostSamples = 1e6;  // a border; longer ones take longer steps
constexpr double kFar = std::numeric_limits<double>::infinity();

struct BorderEdge {
  Vec2 a, b;
};

std::vector<BorderEdge> edges_of(std::span<const PolygonWithHoles> region) {
  std::vector<BorderEdge> out;
  const auto add = [&](const std::vector<Vec2>& ring) {
    for (size_t i = 0; i < ring.size(); ++i) out.push_back({ring[i], ring[(i + 1) % ring.size()]});
  };
  for (const PolygonWithHoles& polygon : region) {
    add(polygon.outline);
    for (const auto& hole : polygon.holes) add(hole);
  }
  return out;
}

// Nearest border by blocks of successive edges, each with its box.
class BorderIndex {
 public:
  explicit BorderIndex(const std::vector<BorderEdge>& edges) : edges_(edges) {
    for (size_t first = 0; first < edges.size(); first += kEdgesPerBlock) {
      Block block{{kFar, kFar}, {-kFar, -kFar}};
      for (size_t i = first; i < std::min(edges.size(), first + kEdgesPerBlock); ++i)
        for (const Vec2& p : {edges[i].a, edges[i].b}) {
          block.low = {std::min(block.low.u, p.u), std::min(block.low.v, p.v)};
          block.high = {std::max(block.high.u, p.u), std::max(block.high.v, p.v)};
        }
      blocks_.push_back(block);
    }
  }

  double distance(const Vec2& p) {
    double best = in_block(last_, p, kFar);  // the next sample is mostly near the same edges
    for (size_t b = 0; b < blocks_.size(); ++b)
      if (b != last_ && box_distance(blocks_[b], p) < best)
        if (const double d = in_block(b, p, best); d < best) {
          best = d;
          nearest_ = b;
        }
    last_ = nearest_;
    return best;
  }

 private:
  struct Block {
    Vec2 low, high;
  };

  static double box_distance(const Block& box, const Vec2& p) {
    const double du = std::max({box.low.u - p.u, 0.0, p.u - box.high.u}),
                 dv = std::max({box.low.v - p.v, 0.0, p.v - box.high.v});
    return std::sqrt(du * du + dv * dv);
  }

  double in_block(size_t b, const Vec2& p, double best) const {
    const size_t first = b * kEdgesPerBlock;
    for (size_t i = first; i < std::min(edges_.size(), first + kEdgesPerBlock); ++i)
      best = std::min(best, segment_distance(p, edges_[i].a, edges_[i].b));
    return best;
  }

  const std::vector<BorderEdge>& edges_;
  std::vector<Block> blocks_;
  size_t last_ = 0, nearest_ = 0;
};

struct Sample {
  double distance_m, length_m;
};

// The distance that 95 % of the length stays below.
double quantile95(std::vector<Sample>& samples, double length_m) {
  std::sort(samples.begin(), samples.end(),
            [](const Sample& a, const Sample& b) { return a.distance_m < b.distance_m; });
  double so_far = 0;
  for (const Sample& s : samples)
    if ((so_far += s.length_m) >= 0.95 * length_m) return s.distance_m;
  return samples.back().distance_m;
}

BorderSpread spread_of(const std::vector<BorderEdge>& from, BorderIndex& to, double tolerance_m,
                       double step_m) {
  double length_m = 0, sum = 0, squares = 0, within = 0;
  for (const BorderEdge& e : from) length_m += norm(e.b - e.a);
  BorderSpread out;
  if (!(length_m > 0)) return out;
  const double step = std::max(step_m, length_m / kMostSamples);
  std::vector<Sample> samples;
  out.max_m = 0;
  for (const BorderEdge& e : from) {
    const double length = norm(e.b - e.a);
    const double pieces = std::max(1.0, std::ceil(length / step));
    out.max_m = std::max(out.max_m, to.distance(e.a));
    for (double k = 0.5; k < pieces; ++k) {
      const Sample s{to.distance(e.a + (e.b - e.a) * (k / pieces)), length / pieces};
      samples.push_back(s);
      sum += s.length_m * s.distance_m;
      squares += s.length_m * s.distance_m * s.distance_m;
      if (s.distance_m <= tolerance_m) within += s.length_m;
      out.max_m = std::max(out.max_m, s.distance_m);
    }
  }
  out.mean_m = sum / length_m;
  out.rms_m = std::sqrt(squares / length_m);
  out.q95_m = quantile95(samples, length_m);
  out.within = std::min(1.0, within / length_m);
  return out;
}

}  // namespace

BorderComparison compare_borders(std::span<const PolygonWithHoles> automatic,
                                 std::span<const PolygonWithHoles> reference, double tolerance_m,
                                 double step_m) {
  const std::vector<BorderEdge> a = edges_of(automatic), r = edges_of(reference);
  BorderComparison out;
  if (a.empty() || r.empty()) return out;
  BorderIndex to_a(a), to_r(r);
  out.automatic = spread_of(a, to_r, tolerance_m, step_m);
  out.reference = spread_of(r, to_a, tolerance_m, step_m);
  const double precision = out.automatic.within, recall = out.reference.within;
  out.f1 = precision + recall > 0 ? 2 * precision * recall / (precision + recall) : 0;
  out.hausdorff_m = std::max(out.automatic.max_m, out.reference.max_m);
  out.hausdorff95_m = std::max(out.automatic.q95_m, out.reference.q95_m);
  return out;
}

}  // namespace jalon
