// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "base/params.h"
#include "registration/targets/settings.h"

namespace jalon {

enum class AngleUnit { kGon, kDegree, kRadian };
/// What holds the network: its fixed and weak points, or nothing but its own shape.
enum class NetworkDatum { kConstrained, kFree };

/// The parameters of operation "network"; standard deviations are those of a total station of one second on tripods.
struct NetworkSettings {
  AngleUnit angle_unit = AngleUnit::kGon;
  NetworkDatum datum = NetworkDatum::kConstrained;
  double sigma_direction_rad = 5e-6;  ///< 3.2 cc, one second of arc
  double sigma_zenith_rad = 5e-6;
  double sigma_distance_m = 0.002;
  double sigma_distance_ppm = 2;
  double sigma_centring_m = 0.001;         ///< of the instrument, in x and y each
  double sigma_target_centring_m = 0.001;  ///< of each target that is set up, in x and y each
  double sigma_height_m = 0.001;           ///< of the instrument's height
  double sigma_target_height_m = 0.001;
  double refraction = 0.13;  ///< coefficient k (Gauss): curvature of the sight over the Earth's
  double earth_radius_m = 6.371e6;
  double scale = 1;  ///< a length in the map over its length in the field
  SnoopingSettings snooping;
  bool reject = false;
  double tolerance_m = 1e-7;  ///< of the last step
  int most_iterations = 30;
};

std::span<const ParamRow> network_rows();

}  // namespace jalon
