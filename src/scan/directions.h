// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "base/task.h"
#include "geometry/vec.h"
#include "scan/static_settings.h"

namespace jalon {

constexpr double kMaxRays = 0x1.0p36;  ///< a station

/// The rays of a station: so many columns of so many rays.
struct RayGrid {
  uint64_t columns = 0, rows = 0;
  uint64_t rays() const { return columns * rows; }
};
/// Throws kInvalidArgument or kLimit where the angles contradict each other or are too fine.
RayGrid ray_grid(const StaticSettings& settings);

/// The directions of one revolution, by eq. 1.1 (Boulaassal 2010): AH from +Y clockwise toward +X,
/// AV from the horizon.
class Directions {
 public:
  Directions(const StaticSettings& settings, const RayGrid& grid, Task& task);
  const RayGrid& grid() const { return grid_; }
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
  bool by_columns() const { return settings_.order == StaticSettings::Order::kColumns; }
  uint64_t column(uint64_t ray) const {
    return by_columns() ? ray / grid_.rows : ray % grid_.columns;
  }
  uint64_t row(uint64_t ray) const { return by_columns() ? ray % grid_.rows : ray / grid_.columns; }
  double horizontal(uint64_t i) const;
  double vertical(uint64_t j) const;

  const StaticSettings& settings_;
  RayGrid grid_;
  std::vector<SineCosine> horizontal_, vertical_;
};

}  // namespace jalon
