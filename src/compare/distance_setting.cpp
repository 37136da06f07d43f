// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/distance_setting.h"

#include "compare/comparison.h"
#include "compare/model_distance.h"
#include "compare/visibility_params.h"

namespace jalon {

namespace {

constexpr ParamRow kRows[] = {
    number_row("max_distance_m", 0, 0, 1e9, "m", "",
               "Radius beyond which a point counts as without reference (status nothing near); 0 = no limit."),
    kSignedRow,
    kToleranceRow,
    kChordErrorRow,
    bool_row("differences", false, "",
             "Also gives the columns difference_x, _y, _z: from the foot on the reference to the compared point."),
    bool_row("sampling_error", false, "",
             "Also predicts, from the density of the reference, the distance that sampling alone makes."),
    bool_row("hausdorff", false, "",
             "Also measures from the reference to the compared cloud, for the symmetric Hausdorff distance."),
    kVisibilityRow,
    kDepthHorizontalStepRow,
    kDepthVerticalStepRow,
    kDepthCellFactorRow,
    kDepthRuleRow,
    kDepthFillPassesRow,
    kDepthEmptyRow,
    kDepthMarginRow,
    kDepthMarginFactorRow,
    kMaxRangeRow,
    kSecondCentreRow,
    kHiddenRow,
    kHiddenDirectionRow,
    kHiddenRadiusRow,
    kHiddenZoneRow,
    kHiddenShapeRatioRow,
};

}  // namespace

std::span<const ParamRow> distance_rows() { return kRows; }

DistanceSetting distance_setting(const ParamSet& params) {
  DistanceSetting s;
  if (params.number("max_distance_m") > 0) s.max_distance_m = params.number("max_distance_m");
  s.differences = params.flag("differences");
  s.sampling_error = params.flag("sampling_error");
  s.hausdorff = params.flag("hausdorff");
  return s;
}

}  // namespace jalon
