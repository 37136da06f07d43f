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
constexpr double kLeastOfFront = 0.1;  // of the strongest's points: of 3 cm about a window of 1 m
constexpr double kStandsOut = 2;       // times what lies beside a front
constexpr double kBesideFront_m = 0.025;  // the rows of a coarse scan on a reveal lie 2 cm apart
constexpr double kDeepestPane_m = 0.05;   // behind the front of its frame; else a blind
constexpr double kDeepestBlind_m = 0.08;  // that hides what a pane lets through

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

using Layers = std::map<int64_t, Layer>;

// Each layer with its neighbour before it.
Layers pairs_of(const Layers& layers) {
  Layers pairs = layers;
  for (auto& [layer, both] : pairs)
    if (const auto next = layers.find(layer + 1); next != layers.end()) both += next->second;
  return pairs;
}

// The fronts among the layers of an opening: pairs that stand out of those beside them, which reveals and the inner
// sides of a frame fill evenly. A pane that returns, a blind or a panel may have more points than the frame before it.
class Fronts {
 public:
  Fronts(const Layers& pairs, Layers::const_iterator most)
      : pairs_(pairs), most_(most->first), least_(kLeastOfFront * points(most->first)) {}

  // The outermost at or before the one with most points.
  int64_t outermost() const {
    for (int64_t layer = most_ + steps(kDeepestBlind_m); layer >= most_ + 2; --layer)
      if (stands_out(layer)) return layer;
    return most_;
  }
  // How far behind a front the innermost is that may be its pane.
  double pane_behind(int64_t front) const {
    for (int64_t layer = front - steps(kDeepestPane_m); layer < front; ++layer)
      if (layer == most_ || (layer <= front - 2 && stands_out(layer)))
        return static_cast<double>(front - layer) * kLayer_m;
    return 0;
  }

 private:
  static int64_t steps(double depth_m) { return index_of(depth_m + kLayer_m / 2, kLayer_m); }
  double points(int64_t layer) const {
    const auto found = pairs_.find(layer);
    return found == pairs_.end() ? 0.0 : static_cast<double>(found->second.points);
  }
  // On one side (1: before it, -1: behind), but for the strongest and what spreads from it.
  bool stands_over(int64_t layer, int64_t side) const {
    if (std::abs(layer + side - most_) >= 2 && points(layer + side) > points(layer)) return false;
    for (int64_t step = 2; step <= steps(kBesideFront_m); ++step) {
      const int64_t beside = layer + side * step;
      if (std::abs(beside - most_) >= 2 && points(layer) < kStandsOut * points(beside))
        return false;
    }
    return true;
  }
  bool stands_out(int64_t layer) const {
    return points(layer) >= least_ && pairs_.at(layer).places >= kFewestOfFront &&
           stands_over(layer, 1) && stands_over(layer, -1);
  }

  const Layers& pairs_;
  int64_t most_;
  double least_;
};

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
  Layers layers;
  for (const auto& [layer, count] : counts) layers[layer] += {1, std::min(count, full)};
  const Layers pairs = pairs_of(layers);
  const auto most = std::max_element(pairs.begin(), pairs.end(), [](const auto& a, const auto& b) {
    return a.second.points < b.second.points;
  });
  if (most == pairs.end() || most->second.places < kFewestOfFront) return false;
  const Fronts fronts(pairs, most);
  const int64_t outermost = fronts.outermost();
  OpeningFront line{static_cast<double>(outermost + 1) * kLayer_m, 0,
                    fronts.pane_behind(outermost)};
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
