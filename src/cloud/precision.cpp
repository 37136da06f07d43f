// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "cloud/precision.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/setting_rows.h"
#include "geometry/ranging.h"

namespace jalon {

namespace {

// What is common to all points of a station: its position, in the horizontal plane and along its axis.
Symmetric3 station_covariance(const ScannerPrecision& p, const Vec3& up) {
  const double level = p.sigma_station_m * p.sigma_station_m;
  // Boulaassal 2010, D.7: C_scanner = C_0 + diag(0, 0, s_H^2).
  const double height = p.sigma_station_z_m * p.sigma_station_z_m +
                        p.sigma_instrument_height_m * p.sigma_instrument_height_m - level;
  return {level + height * up.x * up.x, height * up.x * up.y, height * up.x * up.z,
          level + height * up.y * up.y, height * up.y * up.z, level + height * up.z * up.z};
}

constexpr double kLeastSnr = 1;  // a pulse that noise hides is none

// The SNR falls with the returned intensity, against a white target met squarely at snr_range_m.
double snr_at(const ScannerPrecision& p, double intensity) {
  if (!(p.snr_range_m > 0)) return p.snr;
  const double full =
      returned_intensity(1, 0, p.incidence_exponent, p.snr_range_m, p.attenuation_per_m);
  return std::max(kLeastSnr, p.snr * intensity / full);
}

}  // namespace

std::span<const ParamRow> precision_rows() {
  constexpr double kRightAngle = std::numbers::pi / 2;
  using S = ScannerPrecision;
  static constexpr auto kRows = setting_rows(
      number_row<&S::sigma_range_m>("sigma_range_m", 0, 100, "m", "",
                                    "Standard deviation of the range (default: Trimble GX)"),
      number_row<&S::range_ppm>("range_ppm", 0, 1e6, "ppm", "",
                                "What is added to it: millionths of the range"),
      number_row<&S::sigma_horizontal_rad>("sigma_horizontal_rad", 0, 1, "rad", "",
                                           "Standard deviation of the horizontal angle"),
      number_row<&S::sigma_vertical_rad>("sigma_vertical_rad", 0, 1, "rad", "",
                                         "Standard deviation of the vertical angle"),
      number_row<&S::beam_divergence_rad>("beam_divergence_rad", 0, 1, "rad", "",
                                          "Full angle of the beam; a quarter of it times the range "
                                          "is added across the ray; 0: left out"),
      number_row<&S::pulse_bandwidth_hz>("pulse_bandwidth_hz", 0, 1e15, "Hz", "",
                                         "Receiver bandwidth, for pulse noise; 0: left out"),
      number_row<&S::snr>("snr", 1e-6, 1e12, "1", "", "Signal-to-noise ratio of a pulse"),
      number_row<&S::snr_range_m>(
          "snr_range_m", 0, 1e6, "m", "",
          "Range at which a white surface met squarely has that ratio; elsewhere it follows the "
          "returned intensity; 0: the same everywhere"),
      number_row<&S::shots>("shots", 1, 1e6, "1", "", "Independent pulses averaged for a point"),
      number_row<&S::reflectance>("reflectance", 1e-6, 1, "1", "",
                                  "Reflection coefficient of the surface"),
      number_row<&S::incidence_exponent>("incidence_exponent", 0, 16, "1", "",
                                         "Power of the cosine of the incidence angle in the "
                                         "returned intensity: 4 (Hancock 1999), 1 (Lambert)"),
      number_row<&S::attenuation_per_m>("attenuation_per_m", 0, 10, "1/m", "",
                                        "Absorption and scattering of the air"),
      number_row<&S::rise_time_s>("rise_time_s", 0, 1, "s", "",
                                  "Rise time of the pulse, for time walk; 0: left out"),
      number_row<&S::time_walk_factor>("time_walk_factor", -1e6, 1e6, "1", "",
                                       "Share of the rise time at the mean amplitude"),
      number_row<&S::amplitude>("amplitude", 1e-6, 1e6, "1", "",
                                "Amplitude of the return against the mean one"),
      number_row<&S::temperature_drift_m_per_k>("temperature_drift_m_per_k", -1, 1, "m/K", "",
                                                "Linear drift of the range with temperature"),
      number_row<&S::temperature_difference_k>("temperature_difference_k", -200, 200, "K", "",
                                               "Temperature less that of the calibration"),
      number_row<&S::sigma_station_m>("sigma_station_m", 0, 1e3, "m", "",
                                      "Standard deviation of the station, each horizontal axis"),
      number_row<&S::sigma_station_z_m>("sigma_station_z_m", 0, 1e3, "m", "",
                                        "Standard deviation of the station's height"),
      number_row<&S::sigma_instrument_height_m>("sigma_instrument_height_m", 0, 1e3, "m", "",
                                                "Standard deviation of the instrument's height"),
      number_row<&S::backsight_distance_m>("backsight_distance_m", 0, 1e6, "m", "",
                                           "Distance of the back-sight target; 0: left out"),
      number_row<&S::sigma_backsight_m>(
          "sigma_backsight_m", 0, 1e3, "m", "",
          "Standard deviation of the coordinates of scanner and back-sight target"),
      number_row<&S::level_sensitivity_rad>(
          "level_sensitivity_rad", 0, kRightAngle, "rad", "",
          "Sensitivity of the level or compensator; a fifth of it is the levelling error"));
  return kRows;
}

double PointBudget::instrument_m() const {
  return std::sqrt(range_m * range_m + horizontal_m * horizontal_m + vertical_m * vertical_m);
}

PointBudget point_budget(const ScannerPrecision& p, const Vec3& ray, const Vec3& up,
                         double incidence_rad) {
  const double d = norm(ray), height = dot(ray, up), reach = norm(cross(ray, up));
  PointBudget out;
  out.intensity = returned_intensity(p.reflectance, incidence_rad, p.incidence_exponent, d,
                                     p.attenuation_per_m);
  out.range_m = p.sigma_range_m + 1e-6 * p.range_ppm * d;
  if (p.pulse_bandwidth_hz > 0)
    out.pulse_m = pulse_noise_m(p.pulse_bandwidth_hz, snr_at(p, out.intensity), p.shots);
  const double azimuth_rad = p.backsight_distance_m > 0
                                 ? azimuth_sigma_rad(p.sigma_backsight_m, p.backsight_distance_m)
                                 : 0;
  const double level_rad = levelling_sigma_rad(p.level_sensitivity_rad);
  PolarSigmas sigmas;
  sigmas.range_m = std::hypot(out.range_m, out.pulse_m);
  sigmas.horizontal_rad = std::hypot(p.sigma_horizontal_rad, azimuth_rad);
  sigmas.vertical_rad =
      std::hypot(p.sigma_vertical_rad, level_rad);  // the vertical axis' tilt along the ray
  sigmas.levelling_rad = level_rad;                 // and across it
  sigmas.lateral_m = out.beam_m = beam_sigma_m(p.beam_divergence_rad, d);
  out.covariance = polar_covariance(ray, up, sigmas);
  const Symmetric3 station = station_covariance(p, up);
  for (size_t i = 0; i < 6; ++i) out.covariance[i] += station[i];
  out.station_m = point_sigma(station);
  out.horizontal_m = reach * p.sigma_horizontal_rad;
  out.vertical_m = d * p.sigma_vertical_rad;
  out.azimuth_m = reach * azimuth_rad;
  out.levelling_m = level_rad * std::hypot(d, height);
  out.range_bias_m =
      temperature_drift_m(p.temperature_drift_m_per_k, p.temperature_difference_k) +
      (p.rise_time_s > 0 ? time_walk_m(p.rise_time_s, p.time_walk_factor, p.amplitude) : 0);
  return out;
}

}  // namespace jalon
