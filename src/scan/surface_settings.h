// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace jalon {

/// Of every scanner: which faces are true planes, and what glass lets through. Its rows:
/// scan/surfaces.h.
struct ScannedSurfaceSettings {
  double truth_min_area_m2 = 0.05;
  double glass_return_min = 1, glass_return_max = 1;  ///< shares of the pulses
};

}  // namespace jalon
