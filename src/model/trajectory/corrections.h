// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "model/trajectory/interpolation.h"

namespace jalon {

/// What is added to the positions of a trajectory in plan: told at control times, linear between them.
/// Motion within an interval stays as it was measured.
struct Corrections {
  std::vector<double> times_s;
  std::vector<Vec2> by_m;

  Vec2 at(const TimePlace& place) const {
    return by_m[place.epoch] * (1 - place.share) + by_m[place.epoch + 1] * place.share;
  }
};

/// The trajectory with its positions corrected. Error(kInvalidArgument) where an epoch is outside of the control times.
Trajectory corrected(const Trajectory& trajectory, const Corrections& corrections);

}  // namespace jalon
