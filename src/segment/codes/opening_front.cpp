// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/codes/opening_front.h"

#include <cmath>
#include <map>

namespace jalon {

namespace {

constexpr double kLayer_m = 0.005;                          // twice the noise of a scanner
constexpr double kAboutFront_m = 0.01, kAtFront_m = 0.005;  // of its points, first and last
constexpr int kFrontRounds = 16, kLastRounds = 3;  // a skewed frame is followed from one end on
constexpr size_t kFewestOfFront = 20;

struct LineSums {
  double n = 0, s = 0, d = 0, ss = 0, sd = 0;
};

}  // namespace

bool find_opening_front(std::span<const Vec2> points, OpeningFront& front) {
  // 1. The fullest layer, with its neighbours: a frame lies across two as often as in one.
  std::map<int64_t, size_t> layers;
  for (const Vec2& p : points) ++layers[static_cast<int64_t>(std::floor(p.v / kLayer_m))];
  size_t most = 0;
  double middle = 0;
  for (const auto& [layer, count] : layers) {
    const auto next = layers.find(layer + 1);
    const size_t both = count + (next == layers.end() ? 0 : next->second);
    if (both <= most) continue;
    most = both;
    middle = static_cast<double>(layer + 1) * kLayer_m;
  }
  if (most < kFewestOfFront) return false;
  // 2. The line through it; corners are measured to some centimetres in depth.
  OpeningFront line{middle, 0};
  for (int round = 0; round < kFrontRounds + kLastRounds; ++round) {
    const double about_m = round < kFrontRounds ? kAboutFront_m : kAtFront_m;
    LineSums sums;
    for (const Vec2& p : points) {
      if (std::fabs(p.v - line.before(p.u)) > about_m) continue;
      sums.n += 1, sums.s += p.u, sums.d += p.v, sums.ss += p.u * p.u, sums.sd += p.u * p.v;
    }
    const double spread = sums.n * sums.ss - sums.s * sums.s;
    if (!(spread > 0)) break;
    line.slope = (sums.n * sums.sd - sums.s * sums.d) / spread;
    line.at_m = (sums.d - line.slope * sums.s) / sums.n;
  }
  front = line;
  return true;
}

}  // namespace jalon
