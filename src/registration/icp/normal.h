// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

#include "base/task.h"
#include "geometry/cholesky.h"
#include "registration/icp/pairs.h"
#include "registration/icp/robust_kernel.h"

namespace jalon {

/// Normal equations of one step: unknowns are a turn (rad) about the centre, scaled by the extent so that it is a
/// length, and a shift (m).
struct IcpSums {
  Square<6> normal{};       ///< sum of w j j^T
  Square<6> noise{};        ///< what the noise of the planes' normals alone puts into it
  Coefficients<6> right{};  ///< sum of -w r j
  double squares = 0;       ///< sum of w r^2
  double weights = 0, slopes = 0;  ///< sums of w and of the slope of w r
  uint64_t pairs = 0, of_moving = 0;  ///< with a weight; those of moving points and reference planes
  IcpSums& operator+=(const IcpSums& b);
};

struct IcpFrame {
  Vec3 centre;        ///< in the reference frame, where it lies after the motion
  double extent_m = 1;
};

IcpSums icp_sums(const IcpClouds& clouds, const IcpPoints& reference, const IcpPoints& moving,
                 const IcpNeighbours& neighbours, const Transform& inner, const PairRule& rule,
                 const RobustKernel& kernel, const IcpFrame& frame, Task& task);

/// Residuals of an even sample of the pairs.
std::vector<float> icp_residual_sample(const IcpClouds& clouds, const IcpPoints& reference, const IcpPoints& moving,
                                       const IcpNeighbours& neighbours, const Transform& inner, const PairRule& rule);

/// The directions of the six unknowns and what the pairs say about each.
struct IcpDirections {
  std::array<Coefficients<6>, 6> unit{};  ///< the weakest first
  std::array<double, 6> information{};    ///< without the share of noise
  std::array<bool, 6> observable{};
};
/// A direction is observable when its information stands out of what noise of the normals alone would give: a plane
/// whose normals scatter by a degree looks as if it held shifts along itself.
IcpDirections icp_directions(const IcpSums& sums);
/// The step in the observable directions.
Coefficients<6> icp_step(const IcpSums& sums, const IcpDirections& directions);

}  // namespace jalon
