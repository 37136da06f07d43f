// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "cloud/cloud.h"
#include "registration/icp/settings.h"

namespace jalon {

/// The points that are registered, and which of the caller's they are.
struct IcpSource {
  CloudPtr cloud;
  std::vector<uint32_t> index;  ///< of the caller's point; empty: the same

  uint32_t original(uint32_t i) const { return index.empty() ? i : index[i]; }
};

/// Edge of the cubes that both clouds should be thinned to, 0 for none. A spinning scanner measures in lines that are
/// far
/// apart: the nearest points of each point lie on its own line and span no plane. Cubes about as wide as the lines are
/// apart make neighbours of several lines.
double thinning_cell_m(const Cloud& reference, const Cloud& moving, const IcpSettings& settings, Task& task);
/// Centroids of the cubes; 0: the cloud itself.
IcpSource thinned_source(const CloudPtr& cloud, double cell_m, Task& task);

}  // namespace jalon
