// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "segment/codes/opening_sides.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace jalon {

namespace {

constexpr double kDeepestSought_m = 0.06;  // a sheet's waves may stand 6 cm before a frame
constexpr double kSteepest = 0.5;          // of a sill or splayed jamb, per metre before the front
constexpr double kAboutSide_m = 0.02;      // of measured corners from the reveals
constexpr double kAtSide_m = 0.005;        // of a reveal's points, last: as at fronts
constexpr int kSideRounds = 12;            // of halving the one to the other, and some more
constexpr size_t kFewestOfSide = 20;

double across(const Vec3& p, size_t side) { return side < 2 ? p.x : p.z; }

bool is_along(const Vec3& p, size_t side, const OpeningEnds& ends) {
  return side < 2 ? p.z > ends.low_m && p.z < ends.high_m : p.x > ends.left_m && p.x < ends.right_m;
}

// The line of least squares through what lies about it, closer each time.
OpeningSides::Side side_of(std::span<const Vec2> section, double about_m) {
  OpeningSides::Side side{false, about_m, 0};
  double reach = kAboutSide_m, widening = kSteepest;
  for (int round = 0; round < kSideRounds; ++round) {
    double n = 0, b = 0, s = 0, bb = 0, bs = 0;
    for (const Vec2& p : section) {
      if (std::fabs(p.v - side.at_m - side.slope * p.u) > reach + widening * p.u) continue;
      n += 1, b += p.u, s += p.v, bb += p.u * p.u, bs += p.u * p.v;
    }
    const double spread = n * bb - b * b;
    if (n < static_cast<double>(kFewestOfSide) || !(spread > 0)) return {};
    side.slope = (n * bs - b * s) / spread;
    side.at_m = (s - side.slope * b) / n;
    reach = std::max(kAtSide_m, reach / 2);
    widening = 0;
  }
  side.is_found =
      std::fabs(side.slope) < kSteepest && std::fabs(side.at_m - about_m) < kAboutSide_m;
  return side;
}

}  // namespace

OpeningSides::OpeningSides(std::span<const Vec3> points, const OpeningFront& front,
                           const OpeningEnds& about) {
  const double ends[] = {about.left_m, about.right_m, about.low_m, about.high_m};
  std::array<std::vector<Vec2>, 4> sections;  // before the front, and across the reveal
  for (const Vec3& p : points) {
    const double before = p.y - front.before(p.x);
    if (before < kBeforeFront_m || before > kDeepestSought_m) continue;
    for (size_t k = 0; k < 4; ++k)
      if (is_along(p, k, about) &&
          std::fabs(across(p, k) - ends[k]) < kAboutSide_m + kSteepest * before)
        sections[k].push_back({before, across(p, k)});
  }
  for (size_t k = 0; k < 4; ++k) sides_[k] = side_of(sections[k], ends[k]);
}

bool OpeningSides::is_reveal(const Vec3& p, const OpeningFront& front) const {
  const double before = p.y - front.before(p.x);
  for (size_t k = 0; k < 4; ++k) {
    const Side& side = sides_[k];
    if (!side.is_found) continue;
    const double off = across(p, k) - side.at_m - side.slope * before;
    if (std::fabs(off) < before * std::sqrt(1 + side.slope * side.slope)) return true;
  }
  return false;
}

}  // namespace jalon
