// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <span>

#include "base/task.h"
#include "geometry/vec.h"

namespace jalon {

/// A point of a plane and how bright it is.
struct BrightPoint {
  double u, v, value;
};

/// The centre of a pattern: four quadrants dark and bright by turns, or a disc of another brightness.
struct PatternCentre {
  Vec2 centre;
  std::array<double, 4> covariance{};       ///< m2, of (u, v), row-major
  double radius_m = 0, radius_sigma_m = 0;  ///< of a disc
  double explained = 0;  ///< share of the variance of the brightness that the pattern explains
  uint64_t points = 0;
};

/// 1. A search on a grid of centres; 2. least squares on the points within the pattern with edges
/// as wide as the points are apart; covariance by White (1982). Nothing when the points show none.
///
/// Before: size_m, edge or diameter of the pattern, above 0; its centre lies within reach_m of the
/// origin. After: a finite centre, fixed in both directions; radius and its sigma of a disc only.
std::optional<PatternCentre> find_checker(std::span<const BrightPoint> points, double size_m,
                                          double reach_m, Task& task);
std::optional<PatternCentre> find_disc(std::span<const BrightPoint> points, double size_m,
                                       double reach_m, Task& task);

}  // namespace jalon
