// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "model/trajectory/gauss_markov.h"

// Heights of a drive by the ground below it. Observations, expected 0: corrections z of the trajectory's control
// heights and errors g of the ground that is known, a Gauss-Markov chain each, and in each interval between two control
// times how far the ground as known is above its points,
//
//   (1 - s) (z_c + g_c) + s (z_{c+1} + g_{c+1}) = rise
namespace jalon {

/// Of one interval between control times.
struct GroundRise {
  uint32_t interval = 0;
  double share = 0;   ///< s: where within the interval its points were seen, on average
  double rise_m = 0;  ///< the ground as known, above the points as given
  double variance_m2 = 0;
  uint64_t points = 0;
};

/// Errors of the ground where the drive passes: sigma everywhere, correlation exp(-way driven / length).
GaussMarkov ground_chain(std::span<const Vec3> controls, double sigma_m, double correlation_m);

/// Of a rise: measured, and by how much the ground's mean error over the interval is off the line between its ends.
double variance_of(const GroundRise& rise, const GaussMarkov& ground);

struct HeightSolution {
  std::vector<double> by_m, sigmas_m;  ///< corrections of the control heights
  double chi_square = 0;               ///< with as many degrees of freedom as rises
};
/// Least squares by the block tridiagonal normal equations (blocks of z_c and g_c); variances must be positive. O(n).
HeightSolution solve_heights(const GaussMarkov& drive, const GaussMarkov& ground,
                             std::span<const GroundRise> rises);

}  // namespace jalon
