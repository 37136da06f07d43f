// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/detection/sweep_height.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace jalon {

namespace {

constexpr size_t kMostTriples = 3000;
constexpr double kSweepNear_m = 15;           // in plan: farther points tell little of a height
constexpr double kBelow_m = 1, kAbove_m = 6;  // of the points' own heights: where it is looked for
constexpr double kCoarse_m = 0.1, kFine_m = 0.002;
constexpr double kEven = 0.1;  // of the step: the angles of a sweep are even to that

/// Three points that follow one another in a sweep: distances in plan and heights.
struct Triple {
  double rho[3], z[3];
};

std::vector<Triple> triples_of(const Cloud& cloud, uint64_t first, uint64_t end,
                               const Vec3& place) {
  std::vector<Triple> out;
  const uint64_t step = std::max<uint64_t>(1, (end - first) / kMostTriples / 3);
  for (uint64_t i = first; i + 2 < end && out.size() < kMostTriples; i += step) {
    Triple t;
    bool is_near = true;
    for (size_t k = 0; k < 3; ++k) {
      const Vec3 p = cloud.point(i + k);
      t.rho[k] = std::hypot(p.x - place.x, p.y - place.y);
      t.z[k] = p.z;
      is_near = is_near && t.rho[k] <= kSweepNear_m && t.rho[k] > 0;
    }
    if (is_near) out.push_back(t);
  }
  return out;
}

/// How uneven the median pair of steps is, as a share of them.
double unevenness(const std::vector<Triple>& triples, double height, std::vector<double>& work) {
  work.clear();
  for (const Triple& t : triples) {
    const double a = std::atan2(t.z[0] - height, t.rho[0]),
                 b = std::atan2(t.z[1] - height, t.rho[1]),
                 c = std::atan2(t.z[2] - height, t.rho[2]);
    const double whole = std::abs(c - a);
    work.push_back(whole > 0 ? std::abs(c - 2 * b + a) / whole : 1);
  }
  const auto middle = work.begin() + static_cast<std::ptrdiff_t>(work.size() / 2);
  std::nth_element(work.begin(), middle, work.end());
  return *middle;
}

}  // namespace

std::optional<double> sweep_height(const Cloud& cloud, uint64_t first, uint64_t end,
                                   const Vec3& place, Task& task) {
  const std::vector<Triple> triples = triples_of(cloud, first, end, place);
  constexpr size_t kLeast = 50;
  if (triples.size() < kLeast) return std::nullopt;
  double low = std::numeric_limits<double>::infinity();
  for (const Triple& t : triples) low = std::min({low, t.z[0], t.z[1], t.z[2]});
  std::vector<double> work;
  double best = low, least = std::numeric_limits<double>::infinity();
  const auto search = [&](double from, double to, double step) {
    for (int k = 0; from + k * step <= to; ++k) {
      if (k % 16 == 0) task.checkpoint(0);
      const double height = from + k * step, value = unevenness(triples, height, work);
      if (value < least) least = value, best = height;
    }
  };
  search(low - kBelow_m, low + kAbove_m, kCoarse_m);
  search(best - kCoarse_m, best + kCoarse_m, kFine_m);
  if (least > kEven) return std::nullopt;
  return best;
}

}  // namespace jalon
