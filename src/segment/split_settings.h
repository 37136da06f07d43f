// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "segment/segmentation.h"
#include "segment/surface_settings.h"

namespace jalon {

/// The parameters of method "split_merge"; the rows stand in split_merge.cpp.
struct SplitSettings {
  SurfaceSettings surface;
  double angle_rad = 0.174533;  ///< between a cell's plane and that of the region it joins
  double least_cell_m = 0;      ///< cells no wider are not split; 0 = two tolerances
};

/// Parameter table of method "split_merge".
std::span<const ParamRow> split_merge_rows();
/// Planes from cells split until flat (see split_merge.cpp for the steps).
Segmentation segment_split_merge(const CloudPtr& cloud, const SplitSettings& settings, Task& task);

}  // namespace jalon
