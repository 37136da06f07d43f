// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

namespace jalon {

// What disturbs a measured range, each as its source has it (after Boulaassal 2010, 5.1, 5.4.1 and
// annexes A.4, D). Angles in radians, ranges in metres, seconds, hertz.

constexpr double kSpeedOfLight_m_s = 299792458;

/// 5.1: returned intensity in proportion to rho cos^p(beta) / R^2 (Hancock 1999: p = 4; Lambert: p
/// = 1), and D.2: what the air takes, exp(-gamma R) (Rueger 1990, D.5). beta beyond a right angle:
/// 0.
double returned_intensity(double reflectance, double incidence_rad, double exponent, double range_m,
                          double attenuation_per_m);
/// D.2: gamma = alpha_m + beta_m + alpha_a + beta_a, absorption and scattering by molecules and aerosols (D.6, 1 / m).
double attenuation_per_m(double molecular_absorption, double molecular_scattering,
                         double aerosol_absorption, double aerosol_scattering);

/// D.1: s_r = 0.35 c / (2 b SNR sqrt(n)), of the mean of n independent pulses (Koskinen et al. 1991, D.1, D.2).
double pulse_noise_m(double bandwidth_hz, double snr, double shots);
/// D.1: s_beam = gamma / 4, at range d sideways by gamma d / 4 (Lichti & Gordon 2004, D.3).
double beam_sigma_m(double divergence_rad, double range_m);
/// D.1: dr = c t_rise k (1 - 1 / d), d the amplitude against the mean one (Moring et al. 1989, D.4): the bias of a
/// stronger (> 0) or weaker return.
double time_walk_m(double rise_time_s, double factor, double amplitude);
/// D.1: linear drift, about 4 mm over 30 K where nothing compensates it (Maatta et al. 1993).
double temperature_drift_m(double drift_m_per_k, double difference_k);

/// D.4: azimuth by a back-sight, s_az = sqrt(2) s_hor / d (D.8).
double azimuth_sigma_rad(double sigma_coordinates_m, double backsight_distance_m);
/// D.4: levelling, s_lv = 0.2 nu, nu the sensitivity of the level or compensator.
double levelling_sigma_rad(double sensitivity_rad);

/// A.4: number of whole wavelengths in 2D from two close ones, when both hold the same number: m = (dl2 - dl1) /
/// (lambda1 - lambda2), rounded (A.7; the thesis prints the denominator with the other sign).
double common_wavelengths(double lambda1_m, double remainder1_m, double lambda2_m,
                          double remainder2_m);
/// A.4: range D from the remainders dl_i of 2D on each wavelength. Close wavelengths (the longest below twice the
/// shortest): the pair with the longest beat tells the number m1 of the longest, the shortest beat
/// last, and 2D = m1 lambda1
/// + dl1 refined by the others. Nested ones: coarse to fine, unambiguous on the longest. The result is the mean over
/// all wavelengths once their numbers are known. Error(kInvalidArgument) for wavelengths that are not positive or
/// equal, or remainders outside them.
double phase_range_m(std::span<const double> wavelengths_m, std::span<const double> remainders_m);

/// 5.4.1: the additive constant of a range finder from a baseline: k = mean(m - L).
struct BaselineConstant {
  uint64_t count = 0;
  double constant_m = 0;  ///< k: measured ranges are too long by it
  double sigma_m = 0;     ///< precision: about the mean, divided by n - 1; NaN for one distance
  double sigma_constant_m = 0;  ///< s / sqrt(n)
  double rms_m = 0;             ///< accuracy before the correction: about the true distances
};
BaselineConstant baseline_constant(std::span<const double> measured_m,
                                   std::span<const double> known_m);

}  // namespace jalon
