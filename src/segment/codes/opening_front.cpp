// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/codes/opening_front.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <vector>

namespace jalon {

namespace {

constexpr double kPlace_m = 0.05;                           // about the spacing of a coarse scan
constexpr double kLayer_m = 0.005;                          // twice the noise of a scanner
constexpr double kAboutFront_m = 0.01, kAtFront_m = 0.005;  // of its points, first and last
constexpr int kFrontRounds = 16, kLastRounds = 3;  // a skewed frame is followed from one end on
constexpr size_t kFewestOfFront = 20;

int64_t index_of(double at, double step) { return static_cast<int64_t>(std::floor(at / step)); }

struct LineSums {
  double n = 0, s = 0, d = 0, ss = 0, sd = 0;
};

}  // namespace

bool find_opening_front(std::span<const Vec3> points, OpeningFront& front) {
  // 1. The layer that covers most, with its neighbour: a frame lies across two as often as in one. By places, not by
  // points: a target on a pane is scanned densely and covers little.
  std::vector<std::array<int64_t, 3>> places;
  for (const Vec3& p : points)
    places.push_back({index_of(p.y, kLayer_m), index_of(p.x, kPlace_m), index_of(p.z, kPlace_m)});
  std::sort(places.begin(), places.end());
  places.erase(std::unique(places.begin(), places.end()), places.end());
  std::map<int64_t, size_t> layers;
  for (const auto& place : places) ++layers[place[0]];
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
    for (const Vec3& p : points) {
      if (std::fabs(p.y - line.before(p.x)) > about_m) continue;
      sums.n += 1, sums.s += p.x, sums.d += p.y, sums.ss += p.x * p.x, sums.sd += p.x * p.y;
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
