// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/task.h"
#include "geometry/cholesky.h"
#include "registration/icp/pairs.h"
#include "registration/icp/robust_kernel.h"

namespace jalon {

/// Normal equations of one step, N x = b: unknowns are a turn (rad) about the centre, scaled by the
/// extent so that it is a length, and a shift (m).
struct IcpSums {
  Square<6> normal{};              ///< N, the sum of w j j^T
  Square<6> noise{};               ///< what the noise of the planes' normals alone puts into it
  Coefficients<6> right{};         ///< b, the sum of -w r j
  double squares = 0;              ///< sum of w r^2
  double weights = 0, slopes = 0;  ///< sums of w and of the slope of w r
  uint64_t pairs = 0,
           of_moving = 0;  ///< with a weight; those of moving points and reference planes
  IcpSums& operator+=(const IcpSums& b);
};

/// What the unknowns refer to.
struct IcpFrame {
  Vec3 centre;  ///< that turns are about, in the reference frame, where it lies after the motion
  double extent_m = 1;
};

/// The sums of all pairs, both ways. After: both matrices are whole, not half; the same bits for
/// any number of threads. O(n).
IcpSums icp_sums(const IcpPairing& at, const RobustKernel& kernel, const IcpFrame& frame,
                 Task& task);

/// Residuals (m) of an even sample of the pairs, in a fixed order; empty where there are none.
std::vector<float> icp_residual_sample(const IcpPairing& at);

/// The directions of the six unknowns and what the pairs say about each.
struct IcpDirections {
  std::array<Coefficients<6>, 6> unit{};  ///< the weakest first
  std::array<double, 6> information{};    ///< without the share of noise
  std::array<bool, 6> observable{};
};
/// Times that the information of a direction must stand out of what noise of the normals alone would
/// give: a plane whose normals scatter by a degree looks as if it held shifts along itself. Where
/// nothing but pairs speaks for it twice as much again: the estimate of the noise is good to some per
/// cent where normals scatter alike in all directions, and to a factor of two where they do not.
inline constexpr double kOverNoise = 10;
/// ... where the surfaces themselves hold it (registration/verdict/slide.h).
inline constexpr double kOverNoiseConfirmed = 1;
/// After: the units are orthonormal.
IcpDirections icp_directions(const IcpSums& sums, double over_noise = kOverNoise);
/// The step x in the observable directions, 0 along the others.
Coefficients<6> icp_step(const IcpSums& sums, const IcpDirections& directions);

}  // namespace jalon
