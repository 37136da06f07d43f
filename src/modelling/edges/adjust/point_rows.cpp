// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "modelling/edges/adjust/point_rows.h"

#include <cmath>
#include <numbers>
#include <vector>

namespace jalon {

namespace {

constexpr size_t kPointRowsMostBlocks = 64;
// Distances of rows looked for, in spacings, by equal steps of their frequency.
constexpr double kLeast = 0.55, kPointRowsMost = 2.2;
constexpr int kFrequencies = 48;
constexpr double kLeastPower = 0.1;  // below, a period among so few points may be chance

struct WeightedPoint {
  double d_m, weight;
};

// The points of a block between two depths, with the weights of Hann's window.
std::vector<WeightedPoint> windowed(const EdgeBlock& block, double first_m, double last_m) {
  std::vector<WeightedPoint> out;
  for (const StripPoint& p : block.points) {
    if (p.d_m < first_m || p.d_m > last_m) continue;
    const double s = std::sin(std::numbers::pi * (p.d_m - first_m) / (last_m - first_m));
    out.push_back({p.d_m, s * s});
  }
  return out;
}

// Power of a frequency in one block: |sum of weights x e^(i f d)|^2 over the squared sum of weights, less what as many
// random points would show.
double power(const std::vector<WeightedPoint>& points, double frequency) {
  double cosines = 0, sines = 0, sum = 0, squares = 0;
  for (const auto& [d_m, weight] : points) {
    const double angle = 2 * std::numbers::pi * frequency * d_m;
    cosines += weight * std::cos(angle);
    sines += weight * std::sin(angle);
    sum += weight;
    squares += weight * weight;
  }
  return sum > 0 ? (cosines * cosines + sines * sines - squares) / (sum * sum) : 0;
}

}  // namespace

Rows find_rows(std::span<const MeasuredEdge* const> edges, double spacing_m) {
  std::vector<const EdgeBlock*> blocks;
  for (const MeasuredEdge* edge : edges)
    for (const EdgeBlock& block : edge->blocks)
      if (block.depth_m >= kStripInward * spacing_m) blocks.push_back(&block);
  if (blocks.empty()) return {};
  const size_t step = blocks.size() / kPointRowsMostBlocks + 1;
  std::vector<std::vector<WeightedPoint>> points;
  for (size_t b = 0; b < blocks.size(); b += step)
    points.push_back(windowed(*blocks[b], spacing_m, kStripInward * spacing_m));
  Rows best;
  double most = kLeastPower;
  for (int k = 0; k < kFrequencies; ++k) {
    const double share = k / (kFrequencies - 1.0);
    const double frequency = ((1 - share) / kPointRowsMost + share / kLeast) / spacing_m;
    double sum = 0, count = 0;
    for (const auto& block : points) {
      sum += power(block, frequency);
      count += 1;
    }
    if (sum / count <= most) continue;
    most = sum / count;
    best = {1 / frequency, std::sqrt(most)};
  }
  return best;
}

}  // namespace jalon
