// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/front/free_space.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"

namespace jalon {

namespace {

constexpr double kFar_m = 1;  // beyond it nothing hangs on the wall or fills its openings
// Nearer, a wall's cells are too coarse to tell whether a pane is seen past the edge of its opening.
constexpr double kLeastBeyond_m = 0.3;
constexpr double kMostBeyond_m = 30;
constexpr double kBesideWall_m = 2;
constexpr size_t kMostTried = 1 << 13;  // of the places: what they tell is right to a hundredth

// Where tripods stand before a facade.
constexpr double kDistances_m[] = {3, 6, 12, 24, 48};
constexpr double kAlong[] = {-0.5, 0.1, 0.3, 0.5, 0.7, 0.9, 1.5};  // of the wall's length
constexpr double kEye_m = 1.7;                                     // above the ground
constexpr double kMiddle = 0.5;   // of the height: windows, platforms
constexpr double kLowest = 0.01;  // share of the places below the ground: ghosts, cellars
constexpr int kStationsTaken = 4;

std::vector<WallPlace> stations_of(const WallSheet& sheet, double ground, double side) {
  std::vector<WallPlace> out;
  const double width = sheet.right() - sheet.left(), height = sheet.top() - sheet.foot();
  for (const double distance : kDistances_m)
    for (const double along : kAlong)
      for (const double v : {ground + kEye_m, sheet.foot() + kMiddle * height})
        out.push_back({sheet.left() + along * width, v, side * distance});
  return out;
}

bool is_blocked(const WallSheet& sheet, const WallPlace& station, const WallPlace& place) {
  const double t = station.d / (station.d - place.d);
  const size_t cell =
      sheet.cell_of(station.u + t * (place.u - station.u), station.v + t * (place.v - station.v));
  return cell < sheet.cells() && sheet.is_solid(cell);
}

// How many of the places beyond the wall none of a few stations on this side could see: a greedy cover.
double unexplained(const WallSheet& sheet, const std::vector<WallPlace>& places,
                   const std::vector<WallPlace>& stations, Task& task) {
  std::vector<std::vector<uint8_t>> hides(stations.size());
  parallel_chunks(task, stations.size(), [&](size_t s) {
    hides[s].resize(places.size());
    for (size_t i = 0; i < places.size(); ++i)
      hides[s][i] = is_blocked(sheet, stations[s], places[i]);
  });
  std::vector<uint8_t> left(places.size(), 1);
  size_t count = places.size();
  for (int k = 0; k < kStationsTaken && count > 0; ++k) {
    size_t best = 0, least = count;
    for (size_t s = 0; s < stations.size(); ++s) {
      size_t hidden = 0;
      for (size_t i = 0; i < places.size(); ++i) hidden += left[i] & hides[s][i];
      if (hidden < least) least = hidden, best = s;
    }
    if (least == count) break;
    for (size_t i = 0; i < places.size(); ++i) left[i] &= hides[best][i];
    count = least;
  }
  return static_cast<double>(count);
}

// Height of the ground, or of the lowest that was measured.
double ground_of(const WallSheet& sheet, const std::vector<WallPlace>& before,
                 const std::vector<WallPlace>& behind) {
  std::vector<double> heights;
  heights.reserve(before.size() + behind.size());
  for (const auto* places : {&before, &behind})
    for (const WallPlace& p : *places) heights.push_back(p.v);
  if (heights.empty()) return sheet.foot();
  const auto low =
      heights.begin() + static_cast<ptrdiff_t>(kLowest * static_cast<double>(heights.size()));
  std::nth_element(heights.begin(), low, heights.end());
  return std::min(sheet.foot(), *low);
}

}  // namespace

void look_through(const SparsePlaces& cloud, const WallSheet& sheet, FrontEvidence& evidence,
                  Task& task) {
  std::vector<WallPlace> before, behind;
  size_t far_before = 0, far_behind = 0;
  for (size_t i = 0; i + 2 < cloud.xyz.size(); i += 3) {
    const WallPlace p = sheet.place_of({cloud.xyz[i], cloud.xyz[i + 1], cloud.xyz[i + 2]});
    const double off_m = std::fabs(p.d);
    if (off_m < kLeastBeyond_m || off_m > kMostBeyond_m || p.u < sheet.left() - kBesideWall_m ||
        p.u > sheet.right() + kBesideWall_m)
      continue;
    (p.d > 0 ? before : behind).push_back(p);
    if (off_m > kFar_m) ++(p.d > 0 ? far_before : far_behind);
  }
  const double area_m2 = cloud.cell_m * cloud.cell_m;
  evidence.reach = {area_m2 * static_cast<double>(far_before),
                    area_m2 * static_cast<double>(far_behind)};
  const double ground = ground_of(sheet, before, behind);
  const auto blocked = [&](std::vector<WallPlace>& places, double side) {
    const size_t stride = places.size() / kMostTried + 1;
    std::vector<WallPlace> tried;
    for (size_t i = 0; i < places.size(); i += stride) tried.push_back(places[i]);
    return area_m2 * static_cast<double>(stride) *
           unexplained(sheet, tried, stations_of(sheet, ground, side), task);
  };
  evidence.blocked = {blocked(behind, 1), blocked(before, -1)};
}

}  // namespace jalon
