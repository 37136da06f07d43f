// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/m3c2/surfaces.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace jalon {

namespace {

// Shortest interval that holds half of the points, over that of the standard normal distribution, with the correction
// of Rousseeuw & Leroy (1988) for small samples.
double shortest_half_sigma(std::span<const double> ascending) {
  constexpr double kNormalHalf = 1.3489795003921634;
  const size_t half = ascending.size() / 2 + 1;
  double least = std::numeric_limits<double>::infinity();
  for (size_t i = 0; i + half <= ascending.size(); ++i)
    least = std::min(least, ascending[i + half - 1] - ascending[i]);
  return least / kNormalHalf * (1 + 5 / static_cast<double>(ascending.size() - 1));
}

// Calls keep(i) for the points that have enough company within half a gap, themselves counted.
template <class Keep>
void for_each_accompanied(std::span<const double> ascending, double gap, Keep keep) {
  constexpr size_t kLonely =
      50;  // a surface that gives fewer than one point in so many is no surface here
  const size_t n = ascending.size(), company = std::max<size_t>(2, n / kLonely);
  size_t low = 0, high = 0;
  for (size_t i = 0; i < n; ++i) {
    while (ascending[i] - ascending[low] > 0.5 * gap) ++low;
    while (high < n && ascending[high] - ascending[i] <= 0.5 * gap) ++high;
    if (high - low >= company) keep(i);
  }
}

double middle(std::span<const double> ascending, const CylinderSurface& s) {
  return 0.5 * (ascending[s.first + (s.count - 1) / 2] + ascending[s.first + s.count / 2]);
}

// How far the surface lies from the core point; 0 when that is among its points.
double from_core(std::span<const double> ascending, const CylinderSurface& s) {
  const double low = ascending[s.first], high = ascending[s.first + s.count - 1];
  return std::max(0.0, std::max(low, -high));
}

template <class Far>
size_t least(std::span<const CylinderSurface> surfaces, Far far) {
  size_t best = 0;
  for (size_t i = 1; i < surfaces.size(); ++i)
    if (far(surfaces[i]) < far(surfaces[best])) best = i;
  return best;
}

}  // namespace

std::span<const CylinderSurface> SurfaceFinder::operator()(std::span<const double> ascending) {
  surfaces_.clear();
  const size_t n = ascending.size();
  if (n < min_points_) return surfaces_;
  if (gap_m_ == 0 || ascending[n - 1] - ascending[0] <= gap_m_) {
    surfaces_.push_back({0, n});
    return surfaces_;
  }
  split(ascending, gap_m_);
  // A gap for smooth surfaces takes a rough one to pieces: the largest piece tells how rough.
  const auto larger = [](const CylinderSurface& a, const CylinderSurface& b) {
    return a.count < b.count;
  };
  const auto largest = std::max_element(surfaces_.begin(), surfaces_.end(), larger);
  constexpr double kTails = 5;
  const double gap =
      kTails * shortest_half_sigma(largest == surfaces_.end()
                                       ? ascending
                                       : ascending.subspan(largest->first, largest->count));
  if (gap > gap_m_) split(ascending, gap);
  return surfaces_;
}

// Runs of accompanied points without a wider gap.
void SurfaceFinder::split(std::span<const double> ascending, double gap) {
  surfaces_.clear();
  size_t last = 0;
  for_each_accompanied(ascending, gap, [&](size_t i) {
    if (surfaces_.empty() || ascending[i] - ascending[last] > gap) surfaces_.push_back({i, 0});
    last = i;
    surfaces_.back().count = i + 1 - surfaces_.back().first;
  });
  std::erase_if(surfaces_, [&](const CylinderSurface& s) { return s.count < min_points_; });
}

SurfacePair nearest_surfaces(std::span<const double> reference,
                             std::span<const CylinderSurface> reference_surfaces,
                             std::span<const double> compared,
                             std::span<const CylinderSurface> compared_surfaces) {
  const auto far_reference = [&](const CylinderSurface& s) { return from_core(reference, s); };
  const auto far_compared = [&](const CylinderSurface& s) { return from_core(compared, s); };
  SurfacePair pair{least(reference_surfaces, far_reference),
                   least(compared_surfaces, far_compared)};
  if (far_reference(reference_surfaces[pair.reference]) <=
      far_compared(compared_surfaces[pair.compared])) {
    const double anchor = middle(reference, reference_surfaces[pair.reference]);
    pair.compared = least(compared_surfaces, [&](const CylinderSurface& s) {
      return std::fabs(middle(compared, s) - anchor);
    });
  } else {
    const double anchor = middle(compared, compared_surfaces[pair.compared]);
    pair.reference = least(reference_surfaces, [&](const CylinderSurface& s) {
      return std::fabs(middle(reference, s) - anchor);
    });
  }
  return pair;
}

}  // namespace jalon
