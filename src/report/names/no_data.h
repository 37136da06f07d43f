// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/model.h"

namespace jalon {

/// What of the walls nobody measured: parts of class no_data.
struct NoData {
  size_t count = 0;
  double area_m2 = 0;       ///< of their faces
  double wall_area_m2 = 0;  ///< of the walls' faces
  /// Of both areas together; 0 without any.
  double share() const { return area_m2 > 0 ? area_m2 / (area_m2 + wall_area_m2) : 0; }
};

NoData no_data_of(const Model& model);

}  // namespace jalon
