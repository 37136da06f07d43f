// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "registration/icp/clouds.h"
#include "registration/icp/normal.h"
#include "registration/icp/settings.h"
#include "registration/icp/thinning.h"

namespace jalon {

/// What is given to the iterations, and does not change with the pose.
struct IcpProblem {
  IcpSettings settings;
  ThinnedCloud thinned_reference, thinned_moving;
  IcpClouds clouds;     ///< the surfaces of the thinned ones
  ThinningCells cells;  ///< that both were thinned to
  Vec3 centre;          ///< of the moving points, in the moving frame
  double extent_m = 1;  ///< their radius of gyration: makes turns lengths; above 0

  IcpFrame frame(const Transform& T_reference_moving) const {
    return {T_reference_moving.point(centre), extent_m};
  }
};

}  // namespace jalon
