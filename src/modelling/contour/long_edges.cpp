// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/contour/long_edges.h"

#include <algorithm>
#include <utility>

namespace jalon {

namespace {

constexpr double kFallbackSpacings = 3;
constexpr double kCurveEnd =
    10;  // spacings: the few edges across whole openings would flatten the rest of the curve

}  // namespace

std::vector<double> edge_lengths(std::span<const Vec2> points,
                                 std::span<const Triangle2> triangles) {
  std::vector<uint64_t> edges;
  edges.reserve(3 * triangles.size());
  for (const Triangle2& t : triangles)
    for (size_t k = 0; k < 3; ++k) {
      const uint64_t a = t[k], b = t[(k + 1) % 3];
      edges.push_back(std::min(a, b) << 32 | std::max(a, b));
    }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  std::vector<double> lengths;
  lengths.reserve(edges.size());
  for (const uint64_t e : edges) lengths.push_back(norm(points[e & 0xffffffffu] - points[e >> 32]));
  std::sort(lengths.begin(), lengths.end());
  return lengths;
}

double long_edge_threshold(std::span<const double> lengths, double spacing_m) {
  const double end = kCurveEnd * spacing_m;
  const auto count =
      static_cast<size_t>(std::upper_bound(lengths.begin(), lengths.end(), end) - lengths.begin());
  double knee = kFallbackSpacings * spacing_m, farthest = 0;
  for (size_t i = 0; i < count; ++i) {
    const double along = static_cast<double>(i + 1) / static_cast<double>(count);
    const double below = along - (lengths[i] - lengths[0]) / (end - lengths[0]);
    if (below <= farthest) continue;
    farthest = below;
    knee = lengths[i];
  }
  return std::clamp(knee, kLeastSpacings * spacing_m, kMostSpacings * spacing_m);
}

std::vector<uint32_t> long_edge_points(std::span<const Vec2> points,
                                       std::span<const Triangle2> triangles, double threshold_m) {
  std::vector<uint8_t> is_contour(points.size(), 0);
  for (const Triangle2& t : triangles)
    for (size_t k = 0; k < 3; ++k) {
      const uint32_t a = t[k], b = t[(k + 1) % 3];
      if (norm(points[a] - points[b]) > threshold_m) is_contour[a] = is_contour[b] = 1;
    }
  std::vector<uint32_t> out;
  for (uint32_t i = 0; i < is_contour.size(); ++i)
    if (is_contour[i] != 0) out.push_back(i);
  return out;
}

}  // namespace jalon
