// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "base/params.h"
#include "spatial/voxels/components.h"

namespace jalon {

/// Which points are changed, and which of them belong together; also where the diagnosis starts
/// from.
struct RegionSettings {
  enum class Criterion { kAutomatic, kThreshold, kSignificance, kField };
  Criterion criterion = Criterion::kAutomatic;
  double threshold_m = 0.05;
  double spacing_share = 0.6;     ///< of the column reference_spacing, added to the threshold
  std::string field = "changed";  ///< of kField
  double cell_m = 0;              ///< 0: from the density of the changed points
  Connectivity3 connectivity = Connectivity3::k26;
  uint64_t min_points = 10;
  double twin_reach = 1.5;  ///< of the diagnosis by evidence: in sizes of the thing
};
/// Parameter table of the operations "regions" and "diagnosis".
std::span<const ParamRow> regions_rows();

}  // namespace jalon
