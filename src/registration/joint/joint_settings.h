// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "base/params.h"

namespace jalon {

/// The settings of operation "adjust".
struct JointSettings {
  double sigma_block_x_m = 1, sigma_block_y_m = 1, sigma_facade_m = 0.5, sigma_strip_m = 0.3;
  enum class SetBack { kEither, kBehind } set_back = SetBack::kEither;
  double strip_correlation_m = 0;
  double sigma_roll_bias_rad = 0, sigma_pitch_bias_rad = 0, sigma_heading_bias_rad = 0;
  double sigma_ground_m = 0, ground_correlation_m = 25;
  std::vector<double> control_points{};
  double control_s = 1;
  enum class Matches { kRays, kIds } matches = Matches::kRays;
  enum class Bound { kLogarithm, kNormal } bound = Bound::kLogarithm;
  double refused_share = 0.05;
  bool occluders = true;
  std::vector<double> lever_arm_m{0, 0, 0};
  double thin_m = 0.2, least_score = 0.8, greatest_turn_rad = 0.35;
  uint64_t least_points = 5;
  double sigma_point_m = 0.005;
  enum class Kernel { kTukey, kNone } kernel = Kernel::kTukey;
  bool exchange = true;
  int64_t most_passes = 20;
  double tolerance_m = 0.001;
  bool covariance = false;
  enum class CovarianceOf { kPlaces, kAll } covariance_of = CovarianceOf::kPlaces;

  /// Of constant errors of the attitudes; whether they are adjusted.
  std::array<double, 3> sigma_attitude_rad() const {
    return {sigma_roll_bias_rad, sigma_pitch_bias_rad, sigma_heading_bias_rad};
  }
  bool has_attitude() const {
    return sigma_roll_bias_rad > 0 || sigma_pitch_bias_rad > 0 || sigma_heading_bias_rad > 0;
  }
};
std::span<const ParamRow> joint_rows();

}  // namespace jalon
