// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <numbers>

namespace jalon {

/// The parameters of method "coarse"; the rows stand in rows.h.
struct CoarseSettings {
  double coarse_cell_m = 0;  ///< 0: so that the larger cloud has about `cells` of them
  uint64_t cells = 15000;
  bool gravity = false;  ///< z is up in both clouds
  double max_turn_rad = std::numbers::pi;
  double max_shift_m = 0;            ///< 0: any
  double ambiguous_percent = 85;     ///< of the best score: a rival
  double min_likeness_percent = 62;  ///< of the salient places
  double min_common_percent = 5;     ///< of the moving cloud's surface
};

}  // namespace jalon
