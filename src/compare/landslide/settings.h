// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/params.h"
#include "geometry/vec.h"

namespace jalon {

/// The parameters of method "landslide"; see landslide_rows() for what they mean. Lists are as they were given: check()
/// first.
struct LandslideSettings {
  enum class Stations { kAutomatic, kNone };

  std::vector<double> direction;  ///< none: upward, or across a steep ground
  double cell_m = 0;              ///< 0: by the points
  uint32_t min_points = 6;        ///< of either epoch in a cell that is measured
  double confidence = 0.95;
  double alignment_sigma_m = 0;
  double min_area_m2 = 0;  ///< 0: three cells
  Stations stations = Stations::kAutomatic;
  double max_range_m = 0;       ///< of the scanners; 0: unknown
  std::vector<double> outline;  ///< x, y, z of the corners; none: what either epoch has seen

  /// Throws kInvalidArgument where a list has not as many numbers as it needs.
  void check() const;
  std::vector<Vec3> corners() const;
};

/// Parameter table of method "landslide".
std::span<const ParamRow> landslide_rows();

}  // namespace jalon
