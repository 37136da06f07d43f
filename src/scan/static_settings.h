// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "base/params.h"
#include "base/task.h"
#include "geometry/vec.h"

namespace jalon {

constexpr double kMaxRays = 0x1.0p36;  ///< a station

constexpr int kMostBeamRings = 5;

/// Which of the returns of one pulse is recorded.
enum class EchoChoice { kFirst, kLast, kStrongest };

/// The parameters of the static scanner, read once.
struct StaticSettings {
  double horizontal_from, vertical_from, horizontal_step, vertical_step;
  uint64_t columns, rows;
  bool by_columns;
  double min_range, max_range;
  double range_noise, range_noise_ppm, horizontal_noise, vertical_noise, point_noise;
  double misfit_shift, misfit_rotation;
  double beam_diameter, beam_divergence;  ///< full widths, at the exit and as an angle
  int beam_rings;
  double range_resolution;
  EchoChoice echo;
  double dropout, outliers;
  bool outliers_in_box;
  double step_m;  ///< of the recorded coordinates
  Vec3 offset;
  uint64_t seed;
  bool with_incidence;
  uint64_t max_points;   ///< 0: all
  double spacing_m;      ///< 0: all
  uint64_t stations;     ///< automatic ones; 0: as the model asks for
  double station_distance_m;

  bool has_beam() const { return beam_rings > 0 && (beam_diameter > 0 || beam_divergence > 0); }
  uint64_t rays() const { return columns * rows; }
};

/// Throws kInvalidArgument or kLimit where parameters contradict each other.
StaticSettings static_settings(const ParamSet& params);

/// The directions of one revolution, by eq. 1.1 (Boulaassal 2010): AH from +Y clockwise toward +X, AV from the
/// horizon.
class Directions {
 public:
  Directions(const StaticSettings& settings, Task& task);
  Vec3 of(uint64_t ray) const { return polar(horizontal_[column(ray)], vertical_[row(ray)]); }
  /// Cosine of the ray's vertical angle.
  double of_horizon(uint64_t ray) const { return vertical_[row(ray)].cosine; }
  /// With these errors of the two angles.
  Vec3 of(uint64_t ray, double error_h_rad, double error_v_rad) const;

 private:
  struct SineCosine {
    double sine, cosine;
  };
  static SineCosine sine_cosine(double angle) { return {std::sin(angle), std::cos(angle)}; }
  static Vec3 polar(const SineCosine& h, const SineCosine& v) {
    return {v.cosine * h.sine, v.cosine * h.cosine, v.sine};
  }
  uint64_t column(uint64_t ray) const {
    return settings_.by_columns ? ray / settings_.rows : ray % settings_.columns;
  }
  uint64_t row(uint64_t ray) const { return settings_.by_columns ? ray % settings_.rows : ray / settings_.columns; }
  double horizontal(uint64_t i) const;
  double vertical(uint64_t j) const;

  const StaticSettings& settings_;
  std::vector<SineCosine> horizontal_, vertical_;
};

}  // namespace jalon
