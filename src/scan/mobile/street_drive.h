// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "base/params.h"
#include "model/model.h"
#include "model/trajectory/trajectory.h"

namespace jalon {

/// The settings of operation "street_drive".
struct StreetDriveSettings {
  double leg_m = 132.5;
  bool corner = true;
  bool closed = false;
  double speed_m_s = 5, epochs_per_s = 100;
  double sigma_position_m = 0.02, sigma_velocity_m_s = 0.01,
         sigma_attitude_rad = 8.726646259971648e-05;
  std::vector<double> shift_m{0, 0, 0};
  uint64_t seed = 1;
};
std::span<const ParamRow> street_drive_rows();

/// A street of one leg or two, in an L, and the drive through it. To either side of a leg stand blocks
/// of four houses, four blocks outside of the corner and three inside, 3 m short of the next; fronts
/// are set back 0, 0.3 ... 1.2 m from a line 8 m from the axis and turned by up to 0.05 rad: as drawn, or, of seed 0,
/// by the next of these five and of -0.05, 0 and 0.05 rad, so that no block is held worse than others along its street.
/// Parts:
/// a building a house, with its front alone, or closed, with ground and things that a model lacks (class "element").
struct StreetDrive {
  Model model;
  Trajectory trajectory;
};
StreetDrive street_drive(const StreetDriveSettings& settings);

}  // namespace jalon
