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
constexpr size_t kFewestOfFront = 20;              // places

int64_t index_of(double at, double step) { return static_cast<int64_t>(std::floor(at / step)); }

struct Layer {
  size_t places = 0, points = 0;
  Layer& operator+=(const Layer& b) {
    places += b.places, points += b.points;
    return *this;
  }
};

// Points that a place holds at most but for the densest tenth.
size_t full_place(const std::vector<std::pair<int64_t, size_t>>& counts) {
  constexpr double kMostPlaces = 0.9;
  std::vector<size_t> sizes;
  for (const auto& [layer, count] : counts) sizes.push_back(count);
  if (sizes.empty()) return 0;
  const auto at = sizes.begin() +
                  static_cast<std::ptrdiff_t>(kMostPlaces * static_cast<double>(sizes.size() - 1));
  std::nth_element(sizes.begin(), at, sizes.end());
  return *at;
}

struct LineSums {
  double n = 0, s = 0, d = 0, ss = 0, sd = 0;
};

}  // namespace

bool find_opening_front(std::span<const Vec3> points, OpeningFront& front) {
  // 1. The layer with the most points, with its neighbour: a frame lies across two as often as in one. No place counts
  // for more than most do: a target on a pane is scanned densely and covers little, the pane returns little and covers
  // much.
  std::vector<std::array<int64_t, 3>> places;
  for (const Vec3& p : points)
    places.push_back({index_of(p.y, kLayer_m), index_of(p.x, kPlace_m), index_of(p.z, kPlace_m)});
  std::sort(places.begin(), places.end());
  std::vector<std::pair<int64_t, size_t>> counts;  // layer of a place, and its points there
  for (size_t first = 0, end = 0; first < places.size(); first = end) {
    while (end < places.size() && places[end] == places[first]) ++end;
    counts.push_back({places[first][0], end - first});
  }
  const size_t full = full_place(counts);
  std::map<int64_t, Layer> layers;
  for (const auto& [layer, count] : counts) layers[layer] += {1, std::min(count, full)};
  Layer most;
  double middle = 0;
  for (const auto& [layer, own] : layers) {
    const auto next = layers.find(layer + 1);
    Layer both = own;
    if (next != layers.end()) both += next->second;
    if (both.points <= most.points) continue;
    most = both;
    middle = static_cast<double>(layer + 1) * kLayer_m;
  }
  if (most.places < kFewestOfFront) return false;
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
