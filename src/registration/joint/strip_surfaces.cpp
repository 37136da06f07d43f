// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "registration/joint/strip_surfaces.h"

#include <algorithm>
#include <span>

namespace jalon {

namespace {

// Surfaces are told apart by more than the depth of joinery and of a wall that is some degrees out of its strip's line
// (0.1 m over 1.5 m), and by less than a usual step of a front.
constexpr double kApart_m = 0.15;

// From front to back; each surface ends where the next point is farther than that.
std::vector<std::span<const MetPoint>> surfaces_of(std::span<const MetPoint> from_front) {
  std::vector<std::span<const MetPoint>> made;
  size_t first = 0;
  for (size_t i = 1; i <= from_front.size(); ++i) {
    if (i < from_front.size() &&
        from_front[i - 1].distance_m - from_front[i].distance_m <= kApart_m)
      continue;
    made.push_back(from_front.subspan(first, i - first));
    first = i;
  }
  return made;
}

// All but a twentieth of the points are lower.
double top_of(std::span<const MetPoint> surface) {
  std::vector<double> heights;
  for (const MetPoint& p : surface) heights.push_back(p.height_m);
  const auto at = heights.begin() + static_cast<std::ptrdiff_t>(heights.size() * 19 / 20);
  std::nth_element(heights.begin(), at, heights.end());
  return *at;
}

bool is_passed_over(std::span<const MetPoint> surface, std::span<const MetPoint> all) {
  constexpr double kOver_m = 0.2;
  constexpr size_t kLeastBeams = 5;  // as many as a strip needs to be adjusted
  const double plane = surface[surface.size() / 2].distance_m, top = top_of(surface) + kOver_m;
  size_t over = 0;
  for (const MetPoint& p : all)
    if (p.distance_m < surface.back().distance_m - kApart_m &&
        p.height_m - p.climb * (plane - p.distance_m) > top)
      ++over;
  return over >= kLeastBeams;
}

}  // namespace

std::vector<MetPoint> points_of_wall(std::vector<MetPoint> points) {
  std::sort(points.begin(), points.end(), [](const MetPoint& a, const MetPoint& b) {
    return a.distance_m != b.distance_m ? a.distance_m > b.distance_m : a.number < b.number;
  });
  std::vector<MetPoint> accepted;
  for (const MetPoint& p : points)
    if (p.is_accepted) accepted.push_back(p);
  std::span<const MetPoint> best;
  for (const auto surface : surfaces_of(accepted))
    if (surface.size() > best.size() && !is_passed_over(surface, points)) best = surface;
  return {best.begin(), best.end()};
}

}  // namespace jalon
