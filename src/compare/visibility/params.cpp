// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#include "compare/visibility/params.h"

#include "base/error.h"
#include "compare/visibility/visibility.h"

namespace jalon {

std::span<const ParamRow> visibility_rows() {
  static constexpr ParamRow kRows[] = {kDepthHorizontalStepRow, kDepthVerticalStepRow, kDepthCellFactorRow,
                                       kDepthRuleRow,           kDepthFillPassesRow,   kDepthEmptyRow,
                                       kDepthMarginRow,         kDepthMarginFactorRow, kMaxRangeRow,
                                       kSecondCentreRow};
  return kRows;
}

DepthSettings DepthSettings::from(const ParamSet& params) {
  DepthSettings s;
  s.horizontal_step_rad = params.number("depth_horizontal_step_rad");
  s.vertical_step_rad = params.number("depth_vertical_step_rad");
  s.cell_factor = params.number("depth_cell_factor");
  const std::string& rule = params.text("depth_rule");
  s.rule = rule == "min" ? CellRule::kNearest : rule == "max" ? CellRule::kFarthest : CellRule::kMean;
  s.fill_passes = static_cast<int>(params.integer("depth_fill_passes"));
  s.margin_m = params.number("depth_margin_m");
  s.margin_factor = params.number("depth_margin_factor");
  s.max_range_m = params.number("max_range_m");
  const std::string& empty = params.text("depth_empty");
  s.empty = empty == "free" || (empty == "auto" && s.max_range_m > 0) ? EmptyCell::kFree : EmptyCell::kHides;
  const auto& centre = params.numbers("second_centre_m");
  if (centre.size() != 3) fail(Status::kInvalidArgument, "second_centre_m takes three numbers");
  s.second_centre_m = {centre[0], centre[1], centre[2]};
  return s;
}

}  // namespace jalon
