// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "geometry/primitive_draws.h"
#include "geometry/vec.h"

namespace jalon {

struct Circle {
  Vec2 centre;
  double radius = 0;
  double distance(const Vec2& p) const { return norm(p - centre) - radius; }
};

struct CircleFit {
  Circle circle;
  uint64_t n = 0;
  double sigma = 0;                    ///< m
  std::array<double, 9> covariance{};  ///< of (centre u, v, radius), row-major; NaN for 3 points
};

/// Linear least squares of u^2 + v^2 = A + 2 u u0 + 2 v v0 for 3 points or more, about their centroid (Boulaassal 2010,
/// E.21-E.25). False when they are on one line.
bool circle_linear(std::span<const Vec2> points, Circle& out);
/// 1. start by random draws of 3 points, or linear when not robust; 2. Gauss-Newton with damping (E.1.2). False as for
/// fit_sphere.
bool fit_circle(std::span<const Vec2> points, const PrimitiveSetting& setting, Task& task,
                CircleFit& out);

}  // namespace jalon
