// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "base/params.h"
#include "compare/comparison.h"

namespace jalon {

struct PreviewSettings {
  enum class Measure { kMean, kMinimum, kMaximum, kPlaneAngle };
  Measure measure = Measure::kMean;
  int level = 6;       ///< of the cells
  int last_level = 0;  ///< above level: all from level to this one
};
/// Parameter table of method "preview".
std::span<const ParamRow> preview_rows();
/// Quick look at what changed, cell by cell of one octree around both clouds (Girardeau-Montaut et al. 2005, 3.2): all
/// compared points of a cell get one value, from the reference points of the same cell; those of a cell without any
/// have the status kNothingNear.
Comparison compare_preview(const CloudPtr& reference, const CloudPtr& compared,
                           const PreviewSettings& settings, Task& task);

}  // namespace jalon
