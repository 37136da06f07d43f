// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/ranging.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <vector>

#include "base/error.h"

namespace jalon {

namespace {

struct Wave {
  double length_m, remainder_m;
};

// 2D modulo the beat of two wavelengths, whatever their whole numbers: the difference of their phases.
double on_beat(const Wave& longer, const Wave& shorter) {
  const double beat = longer.length_m * shorter.length_m / (longer.length_m - shorter.length_m);
  double cycles = shorter.remainder_m / shorter.length_m - longer.remainder_m / longer.length_m;
  if (cycles < 0) ++cycles;
  return cycles * beat;
}

// The place nearest to `about` that a wavelength and its remainder allow.
double nearest(const Wave& wave, double about) {
  return std::round((about - wave.remainder_m) / wave.length_m) * wave.length_m + wave.remainder_m;
}

// Double range by ever shorter beats with the longest wavelength.
double double_range_by_beats(const std::vector<Wave>& waves) {
  double place = on_beat(
      waves[0], waves[1]);  // waves fall in length: the second is the closest, its beat the longest
  for (size_t i = 2; i < waves.size(); ++i) {
    const double beat =
        waves[0].length_m * waves[i].length_m / (waves[0].length_m - waves[i].length_m);
    place = nearest({beat, on_beat(waves[0], waves[i])}, place);
  }
  return place;
}

}  // namespace

double returned_intensity(double reflectance, double incidence_rad, double exponent, double range_m,
                          double attenuation) {
  const double cosine = std::max(0.0, std::cos(incidence_rad));
  return reflectance * std::pow(cosine, exponent) / (range_m * range_m) *
         std::exp(-attenuation * range_m);
}

double attenuation_per_m(double molecular_absorption, double molecular_scattering,
                         double aerosol_absorption, double aerosol_scattering) {
  return molecular_absorption + molecular_scattering + aerosol_absorption + aerosol_scattering;
}

double pulse_noise_m(double bandwidth_hz, double snr, double shots) {
  return 0.35 * kSpeedOfLight_m_s / (2 * bandwidth_hz * snr * std::sqrt(shots));
}

double beam_sigma_m(double divergence_rad, double range_m) { return divergence_rad / 4 * range_m; }

double time_walk_m(double rise_time_s, double factor, double amplitude) {
  return kSpeedOfLight_m_s * rise_time_s * factor * (1 - 1 / amplitude);
}

double temperature_drift_m(double drift_m_per_k, double difference_k) {
  return drift_m_per_k * difference_k;
}

double azimuth_sigma_rad(double sigma_coordinates_m, double backsight_distance_m) {
  return std::numbers::sqrt2 * sigma_coordinates_m / backsight_distance_m;
}

double levelling_sigma_rad(double sensitivity_rad) { return 0.2 * sensitivity_rad; }

double common_wavelengths(double lambda1_m, double remainder1_m, double lambda2_m,
                          double remainder2_m) {
  return std::round((remainder2_m - remainder1_m) / (lambda1_m - lambda2_m));
}

double phase_range_m(std::span<const double> wavelengths_m, std::span<const double> remainders_m) {
  std::vector<Wave> waves;
  for (size_t i = 0; i < wavelengths_m.size(); ++i) {
    waves.push_back({wavelengths_m[i], remainders_m[i]});
    if (!(waves[i].length_m > 0) || !std::isfinite(waves[i].length_m) ||
        !(waves[i].remainder_m >= 0) || !(waves[i].remainder_m <= waves[i].length_m))
      fail(Status::kInvalidArgument, "wavelength %zu or its remainder is no length within it", i);
  }
  if (waves.empty()) fail(Status::kInsufficientData, "no wavelengths");
  std::stable_sort(waves.begin(), waves.end(),
                   [](const Wave& a, const Wave& b) { return a.length_m > b.length_m; });
  for (size_t i = 1; i < waves.size(); ++i)
    if (waves[i].length_m == waves[i - 1].length_m)
      fail(Status::kInvalidArgument, "two wavelengths are equal");
  constexpr double kNested = 2;  // the longest against the shortest
  const bool close = waves.size() > 1 && waves.front().length_m < kNested * waves.back().length_m;
  double place = close ? double_range_by_beats(waves) : waves.front().remainder_m;
  double sum = 0;
  for (const Wave& wave : waves) sum += place = nearest(wave, place);
  return sum / static_cast<double>(waves.size()) / 2;
}

BaselineConstant baseline_constant(std::span<const double> measured_m,
                                   std::span<const double> known_m) {
  if (measured_m.empty()) fail(Status::kInsufficientData, "a baseline needs at least one distance");
  BaselineConstant out;
  out.count = measured_m.size();
  const double n = static_cast<double>(out.count);
  double squares = 0, about_mean = 0;
  for (size_t i = 0; i < measured_m.size(); ++i) {
    const double error = measured_m[i] - known_m[i];
    if (!std::isfinite(error)) fail(Status::kInvalidArgument, "distance %zu is not finite", i);
    out.constant_m += error / n;
    squares += error * error;
  }
  for (size_t i = 0; i < measured_m.size(); ++i) {
    const double v = measured_m[i] - known_m[i] - out.constant_m;
    about_mean += v * v;
  }
  out.sigma_m = n > 1 ? std::sqrt(about_mean / (n - 1)) : std::nan("");
  out.sigma_constant_m = out.sigma_m / std::sqrt(n);
  out.rms_m = std::sqrt(squares / n);
  return out;
}

}  // namespace jalon
