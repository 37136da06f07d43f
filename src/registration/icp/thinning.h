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

/// Cubes that clouds are thinned to. A spinning scanner measures in lines that are far apart, the farther the farther
/// off it was: the nearest points of each point lie on its own line and span no plane, or with their noise that of the
/// beam. Points nearer to each other than their noise span that of the noise.
struct ThinningCells {
  double edge_m = 0;      ///< 0: as they are
  bool do_widen = false;  ///< twice as wide, and again, where the points lie in lines still
};

/// What both clouds should be thinned to. O(log n).
ThinningCells thinning_cells(const Cloud& reference, const Cloud& moving,
                             const IcpSettings& settings, Task& task);
/// The cubes' centroids, each with the index of a raw point of its cube, ascending. Of cubes that widen those alone
/// whose neighbours are spread over a surface. Of no cubes the raw cloud itself, not copied. O(n).
ThinnedCloud thinned(const CloudPtr& raw, const ThinningCells& cells, uint32_t k, Task& task);

}  // namespace jalon
