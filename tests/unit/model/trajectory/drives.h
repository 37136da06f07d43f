// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "model/trajectory/trajectory.h"

namespace jalon {

/// A drive of this many epochs with a bend, in coordinates of Lambert-93, with sigmas.
inline Trajectory bent_drive(size_t epochs, double step_s = 1) {
  Trajectory made;
  for (size_t i = 0; i < epochs; ++i) {
    const double s = 5 * step_s * static_cast<double>(i), turned = s / 100;  // 5 m/s, radius 100 m
    made.times_s.push_back(1000 + step_s * static_cast<double>(i));
    made.positions.push_back(
        {652000 + 100 * std::sin(turned), 6861000 + 100 * (1 - std::cos(turned)), 45 + 0.01 * s});
    made.attitudes_rad.push_back({0.01, -0.002, turned});
    made.position_sigmas_m.push_back({0.02 + 0.001 * s, 0.03 + 0.001 * s, 0.05});
    made.velocity_sigmas_m_s.push_back({0.01, 0.02, 0.03});
    made.attitude_sigmas_rad.push_back({1e-4, 1e-4, 3e-4});
  }
  made.crs = "EPSG:2154";
  return made;
}

}  // namespace jalon
