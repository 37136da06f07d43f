// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "geometry/vec.h"

namespace jalon {

/// A nail, a station or an object's point. NaN: a coordinate that is not known, a standard deviation of what is to be
/// determined.
struct SurveyPoint {
  std::string id, code;
  Vec3 position{NAN, NAN, NAN};  ///< as given, else approximate
  Vec3 sigma_m{NAN, NAN, NAN};   ///< 0: fixed; above: weak
  size_t line = 0;               ///< of the list of points; 0: only sighted

  bool is_placed() const { return is_finite(position); }
};

/// What a total station measured in one sight; NaN: not measured.
struct SurveySight {
  size_t line = 0;     ///< of the list of observations
  uint32_t setup = 0;  ///< of the instrument
  uint32_t target = 0;
  double instrument_height_m = 0, target_height_m = 0;  ///< above the points
  double direction_rad = NAN;                           ///< clockwise, from the circle's own zero
  double zenith_rad = NAN;                              ///< 0 upwards, in the first face
  double distance_m = NAN;                              ///< along the slope
  double sigma_direction_rad = NAN, sigma_zenith_rad = NAN,
         sigma_distance_m = NAN;  ///< NaN: settings

  bool is_polar() const {
    return std::isfinite(direction_rad) && std::isfinite(zenith_rad) && std::isfinite(distance_m);
  }
};

/// The instrument on a point, until it is set up anew: one orientation of the circle, one error of centring.
struct SurveySetup {
  std::string name;
  uint32_t station = 0;
};

struct Survey {
  std::vector<SurveyPoint> points;
  std::vector<SurveySetup> setups;
  std::vector<SurveySight> sightings;
};

}  // namespace jalon
