// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "segment/ransac_settings.h"

namespace jalon {

/// The parameters of method "region_growing" as plain values; names, defaults and help stand in
/// region_growing_params.cpp.
struct GrowingSettings {
  RansacSettings planes;  ///< what the steps after the growing read
  uint32_t k = 16;        ///< neighbours of a point's normal, itself included
  double gap_m = 0;       ///< 0 = twice the local spacing
  bool field_normals = false;
};

GrowingSettings growing_settings(const ParamSet& params);

}  // namespace jalon
