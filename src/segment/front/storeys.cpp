// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/front/storeys.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace jalon {

namespace {

constexpr double kNoViewer_m = 1;  // between two planes: as kFar_m of free_space.cpp
constexpr double kStray =
    0.05;  // of a wall's probes at each end: panes of another storey in its plane
constexpr double kOverlapping =
    0.2;                       // of the lower wall's height: what braces and gables reach down
constexpr double kOver = 0.5;  // of the narrower wall's width

struct Range {
  double low = 0, high = 0;
  double length() const { return high - low; }
};
double shared_length(const Range& a, const Range& b) {
  return std::min(a.high, b.high) - std::max(a.low, b.low);
}

// Less strays at both ends.
Range range_of(std::vector<double> at) {
  std::sort(at.begin(), at.end());
  const auto stray = static_cast<size_t>(kStray * static_cast<double>(at.size()));
  return {at[stray], at[at.size() - 1 - stray]};
}

// Of the probes in the frame of a sheet.
struct WallRanges {
  Range u, v, d;

  WallRanges(const WallSheet& sheet, std::span<const Vec3> probes) {
    std::vector<double> us, vs, ds;
    for (const Vec3& probe : probes) {
      const WallPlace p = sheet.place_of(probe);
      us.push_back(p.u);
      vs.push_back(p.v);
      ds.push_back(p.d);
    }
    u = range_of(std::move(us));
    v = range_of(std::move(vs));
    d = range_of(std::move(ds));
  }
};

}  // namespace

bool are_storeys(const ProbedWall& a, const ProbedWall& b) {
  if (a.probes.empty() || b.probes.empty() ||
      std::fabs(dot(a.sheet.normal(), b.sheet.normal())) < kSameDirection)
    return false;
  const WallRanges mine(a.sheet, a.probes), other(a.sheet, b.probes);
  return other.d.low >= -kNoViewer_m && other.d.high <= kNoViewer_m &&
         shared_length(mine.u, other.u) >= kOver * std::min(mine.u.length(), other.u.length()) &&
         shared_length(mine.v, other.v) <=
             kOverlapping * std::min(mine.v.length(), other.v.length());
}

}  // namespace jalon
