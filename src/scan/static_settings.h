// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <numbers>
#include <span>
#include <vector>

#include "base/params.h"
#include "scan/surface_settings.h"

namespace jalon {

constexpr int kMostBeamRings = 5;

/// Of the static scanner. Angles as in scan/directions.h; the table of the rows says what each
/// member means.
struct StaticSettings {
  enum class Instrument { kCustom, kGx };
  enum class Echo { kFirst, kLast, kStrongest };  ///< of the returns of one pulse
  enum class OutlierPlace { kRay, kBox };
  enum class Order { kColumns, kRows };

  // The grid of rays, and what of it is recorded.
  double horizontal_step_rad = 0.0016, vertical_step_rad = 0.0016;
  double horizontal_from_rad = -std::numbers::pi, horizontal_to_rad = std::numbers::pi;
  double vertical_from_rad = -std::numbers::pi / 3, vertical_to_rad = std::numbers::pi / 2;
  double min_range_m = 0.5, max_range_m = 200;

  // Errors of the instrument and of the registration.
  double range_noise_m = 0.003, range_noise_ppm = 0;
  double angle_noise_rad = 2e-5;
  double vertical_noise_rad = -1;  ///< negative: that of the horizontal angle
  double point_noise_m = 0;
  Instrument instrument = Instrument::kCustom;
  double misfit_shift_m = 0, misfit_rotation_rad = 0;

  // The beam.
  double beam_diameter_m = 0;      ///< full width at the exit
  double beam_divergence_rad = 0;  ///< full angle
  int beam_rings = 2;
  double range_resolution_m = 0.3;
  Echo echo = Echo::kFirst;

  ScannedSurfaceSettings surfaces{};
  double dropout = 0, outliers = 0;  ///< shares of the returns
  OutlierPlace outlier_place = OutlierPlace::kRay;

  // The cloud.
  double coordinate_step_m = 0;
  std::vector<double> offset_m{0, 0, 0};
  Order order = Order::kColumns;
  uint64_t max_points = 0;        ///< 0: all
  double spacing_m = 0;           ///< 0: all
  uint64_t stations = 0;          ///< automatic ones; 0: as the model asks for
  double station_distance_m = 0;  ///< 0: by the width of the model
  bool incidence_angle = false;   ///< whether the field is made
  uint64_t seed = 1;

  bool has_beam() const {
    return beam_rings > 0 && (beam_diameter_m > 0 || beam_divergence_rad > 0);
  }
};
std::span<const ParamRow> static_scanner_rows();

/// The settings with the noise and the beam of the chosen instrument in their places, and with a
/// noise of the vertical angle of its own. Throws kInvalidArgument where the limits of the range
/// contradict each other.
StaticSettings resolved(StaticSettings settings);

}  // namespace jalon
