// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "cloud/cloud.h"
#include "compare/comparison.h"
#include "compare/landslide/ground_heights.h"
#include "compare/landslide/settings.h"

namespace jalon {

/// Which cells the survey is about, and what each epoch has in them.
struct SurveyedCells {
  std::vector<uint8_t> is_inside;
  std::vector<CompareStatus> reference, compared;  ///< kCompared: measured in that epoch
  /// Where a cell lies: the compared ground, else the reference's, else that of the cells around. For places only: no
  /// volume is taken from it.
  std::vector<double> place_m;
};

/// 1. Inside are the cells in the outline asked for; else those that either epoch has points in, and those that such
/// enclose. 2. Cells without ground get the mean height of those around, ring by ring. 3. Why a cell was not measured,
/// by the depth maps of that epoch's stations (Girardeau-Montaut 2006, 2.3.3): hidden, out of range or out of the field
/// at that place; too few points, or none though nothing stood before it.
SurveyedCells surveyed_cells(const VolumeGrid& grid, const GroundHeights& before,
                             const GroundHeights& after, const CloudPtr& reference,
                             const CloudPtr& compared, const LandslideSettings& settings,
                             Task& task);

}  // namespace jalon
