// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>

#include "base/params.h"

namespace jalon {

/// The parameters of method "distance", read and checked.
struct DistanceSetting {
  double max_distance_m = std::numeric_limits<double>::infinity();
  bool differences = false;
  bool sampling_error = false;
  bool hausdorff = false;
};

DistanceSetting distance_setting(const ParamSet& params);

}  // namespace jalon
