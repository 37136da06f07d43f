// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "registration/icp/iterations.h"
#include "registration/registration_tables.h"

namespace jalon {

/// What a pose is worth.
struct IcpCovariance {
  Square<6>
      covariance{};  ///< rotation (rad) about the centre, shift (m); NaN where a direction is open
  std::array<PoseDirection, 6> directions;
  double sigma0 = 1;  ///< a posteriori: residuals against what the scatter of the planes foretells
  double redundancy = 0;  ///< points with a say, less the unknowns
};

/// Of pairs: propagates the noise of every point of both clouds to the pose, the way it went: as a
/// point that has a pair, and as one of the neighbours that the planes go through. Pairs are far
/// from independent: neighbouring planes share their points, and each point stands in some sixteen
/// of them; that is why pairs are not counted. Of a pose that settled on patches: that of their
/// adjustment, by the scatter of either cloud's points about each patch.
///
/// Before: the last step was one on all points. After: six directions, those open first, each group
/// with the weakest first; the covariance is NaN as a whole where one direction is open.
///
/// Assumed: noise of points independent of each other, of the local planes' scatter across the
/// surface; the kernel's efficiency for normal noise; surfaces that did not change. Noise that many
/// neighbouring points have in common (a station's orientation, a warped mirror) is not in it.
IcpCovariance icp_covariance(const IcpProblem& problem, const IcpState& state, Task& task);

}  // namespace jalon
