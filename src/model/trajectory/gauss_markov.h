// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "model/trajectory/trajectory.h"

namespace jalon {

/// The error of one coordinate of a trajectory from epoch to epoch, as a first-order Gauss-Markov
/// chain normalised so that each epoch keeps its own standard deviation:
///
///   e_{i+1} = n_i (e_i + dt_i v_i xi),  n_i = sigma_{i+1} / sqrt(sigma_i^2 + dt_i^2 v_i^2)
///
/// sigma: of the position, v: of the velocity, xi: standard normal. cov(e_i, e_j) = sigma_i^2 times
/// the product of n_k, i <= k < j. The innovations q_i = n_i^2 dt_i^2 v_i^2 make the inverse of the
/// covariance matrix tridiagonal. (Velocities of 0 would make it singular: they are refused.)
struct GaussMarkov {
  std::vector<double> sigmas_m;     ///< one an epoch
  std::vector<double> factors;      ///< n_i, one an interval
  std::vector<double> innovations;  ///< q_i (m2), one an interval

  size_t size() const { return sigmas_m.size(); }
  /// Of epochs i and j.
  double covariance(size_t i, size_t j) const;
};
/// Lists of one value an epoch; the velocity sigma of an interval is that of its first epoch.
GaussMarkov gauss_markov(std::span<const double> times_s, std::span<const double> sigmas_m,
                         std::span<const double> velocity_sigmas_m_s);

/// The inverse of its covariance matrix: diagonal (one an epoch) and the elements beside it (one an
/// interval), 1/m2.
struct TridiagonalInformation {
  std::vector<double> diagonal, beside;
};
TridiagonalInformation information_of(const GaussMarkov& chain);

/// One draw of the chain. O(n).
std::vector<double> drawn(const GaussMarkov& chain, uint64_t seed, uint64_t stream);

/// The velocity sigma where a trajectory tells none: of the drift of positions by satellites and
/// inertia, not of the speedometer.
constexpr double kDriftSigma_m_s = 0.01;
/// The chain of one coordinate (0: x, 1: y, 2: z) of a trajectory. Error(kInvalidArgument) where it
/// has no position sigmas.
GaussMarkov position_prior(const Trajectory& trajectory, int axis);
/// The trajectory with x and y moved by a draw each; y draws from the next stream.
Trajectory perturbed(const Trajectory& trajectory, uint64_t seed);

}  // namespace jalon
