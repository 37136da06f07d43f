// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "base/params.h"
#include "base/task.h"
#include "cloud/cloud.h"
#include "model/trajectory/interpolation.h"
#include "model/trajectory/laser_beam.h"

namespace jalon {

/// The settings of operation "georeference". Defaults: a RIEGL scanner on a calibrated mount
/// (Monnier 2014, Stereopolis II).
struct GeoreferenceSettings {
  std::vector<double> mirror_offset_m{0, 0, 0}, boresight_rad{0, 0, 0}, lever_arm_m{0, 0, 0};
  BoresightOrder boresight_order = BoresightOrder::kZyx;
  bool covariances = true;
  double sigma_range_m = 0.005;
  double sigma_theta_rad = 1.7453292519943296e-5,
         sigma_phi_rad = 1.7453292519943296e-5;  // 0.001 deg
  std::vector<double> sigma_mirror_m{0.001, 0.001, 0.001};
  std::vector<double> sigma_boresight_rad{1.7453292519943296e-3, 1.7453292519943296e-3,
                                          1.7453292519943296e-3};  // 0.1 degrees
  std::vector<double> sigma_lever_arm_m{0.001, 0.001, 0.001};
};
std::span<const ParamRow> georeference_rows();

LaserMount mount_of(const GeoreferenceSettings& settings);
/// The 18 sigmas at a place of the trajectory, which has those of position and attitude.
LaserSigmas laser_sigmas(const GeoreferenceSettings& settings);
void set_pose_sigmas(LaserSigmas& sigmas, const Trajectory& trajectory, const TimePlace& place);

/// What a mobile scanner measured, a list each of one value a return.
struct LaserReturns {
  std::span<const double> times_s, ranges_m, thetas_rad, phis_rad;
};

/// The returns as a cloud with the fields "time" (float64, s), "beam_origin" (float64 x 3, m),
/// "beam_direction" (float32 x 3) and, where asked for, "covariance" (float32 x 6, m2) and
/// "point_sigma" (float32, m). Error(kInvalidArgument) naming the first return without a positive
/// range or outside of the trajectory.
Cloud georeferenced(const Trajectory& trajectory, const LaserReturns& returns,
                    const GeoreferenceSettings& settings, Task& task);

}  // namespace jalon
