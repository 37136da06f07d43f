// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>

#include "base/params.h"

namespace jalon {

enum class LocalModelKind { kNone, kPlane, kDelaunay, kQuadric };

/// The parameters of method "distance", read and checked.
struct DistanceSetting {
  double max_distance_m = std::numeric_limits<double>::infinity();
  LocalModelKind model = LocalModelKind::kNone;
  uint32_t k = 0;        ///< reference points of a local model, where radius_m is 0
  double radius_m = 0;
  bool around_point = false;  ///< the neighbourhood is the compared point's, not its nearest reference point's
  bool differences = false;
  bool sampling_error = false;
  bool hausdorff = false;
};

DistanceSetting distance_setting(const ParamSet& params);

}  // namespace jalon
