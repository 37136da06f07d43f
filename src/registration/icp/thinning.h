// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "cloud/cloud.h"
#include "registration/icp/settings.h"

namespace jalon {

/// The points that are registered, and which of the raw ones they are.
struct ThinnedCloud {
  CloudPtr cloud;
  std::vector<uint32_t> index;  ///< of the raw point; empty: the same

  uint32_t raw(uint32_t i) const { return index.empty() ? i : index[i]; }
};

/// Edge of the cubes that both clouds should be thinned to, 0 for none. A spinning scanner measures
/// in lines that are far apart: the nearest points of each point lie on its own line and span no
/// plane. Cubes about as wide as the lines are apart make neighbours of several lines.
double thinning_cell_m(const Cloud& reference, const Cloud& moving, const IcpSettings& settings,
                       Task& task);
/// The cubes' centroids, each with the index of a raw point of its cube. cell_m of 0: the raw cloud
/// itself, not copied.
ThinnedCloud thinned(const CloudPtr& raw, double cell_m, Task& task);

}  // namespace jalon
