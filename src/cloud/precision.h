// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "base/params.h"
#include "cloud/cloud.h"
#include "geometry/polar_covariance.h"

namespace jalon {

/// What a scanner's points are worth (Boulaassal 2010, 5.1, 5.3.3, D): the settings of operation
/// "precision".
struct ScannerPrecision {
  double sigma_range_m = 0.007, range_ppm = 0;
  double sigma_horizontal_rad = 60e-6, sigma_vertical_rad = 70e-6;
  double beam_divergence_rad = 0;
  double pulse_bandwidth_hz = 0, snr = 100, shots = 1;  ///< 0 hertz: no pulse noise
  double snr_range_m = 0;                               ///< 0: one SNR for all points
  double reflectance = 1, incidence_exponent = 4, attenuation_per_m = 0;
  double rise_time_s = 0, time_walk_factor = 1, amplitude = 1;
  double temperature_drift_m_per_k = 0, temperature_difference_k = 0;
  double sigma_station_m = 0, sigma_station_z_m = 0, sigma_instrument_height_m = 0;
  double backsight_distance_m = 0, sigma_backsight_m = 0.002;  ///< 0 m: no azimuth by back-sight
  double level_sensitivity_rad = 0;
};

std::span<const ParamRow> precision_rows();

/// Share of each influence in the position of one point (m, standard deviations), by the general quadrature s =
/// sqrt(sum s_i^2) (Baltsavias 1999).
struct PointBudget {
  double range_m = 0;  ///< the instrument's range, pulse noise not in it
  double pulse_m = 0;
  double horizontal_m = 0, vertical_m = 0, beam_m = 0;
  double azimuth_m = 0, levelling_m = 0, station_m = 0;
  double range_bias_m = 0;      ///< time walk and temperature: systematic, in no standard deviation
  double intensity = 0;         ///< with what the air takes, relative
  Symmetric3 covariance{};      ///< of all of them
  double instrument_m() const;  ///< 5.6: range and angles alone
  double point_m() const { return point_sigma(covariance); }
};
/// ray: from the scanner to the point, not 0; up: the scanner's vertical axis (unit). incidence_rad: between ray and
/// surface normal.
PointBudget point_budget(const ScannerPrecision& precision, const Vec3& ray, const Vec3& up,
                         double incidence_rad);

/// The cloud with the fields "covariance" (float32 x 6: xx, xy, xz, yy, yz, zz, m2) and "point_sigma" (float32, m).
/// Each point needs a station with a pose: Error(kInvalidArgument) naming the first without one, or that lies on it.
Cloud with_point_covariances(const Cloud& cloud, const ScannerPrecision& precision, Task& task);

}  // namespace jalon
