// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "base/params.h"
#include "base/task.h"
#include "model/model.h"
#include "model/trajectory/trajectory.h"
#include "registration/joint/joint_adjustment.h"
#include "report/settings.h"

namespace jalon {

/// Operation "adjustment_report".
struct AdjustmentReportSettings {
  int64_t bins = 60;
  int64_t strips = 30;  ///< most strips in the table of those that moved most
  int64_t viewer_points = kViewerPoints;
};
std::span<const ParamRow> adjustment_report_rows();

/// What was adjusted, as it was given. truth: the drive as it was where that is known, e.g. of a virtual scan, or null.
struct AdjustedInputs {
  const Model& model;
  const Trajectory& trajectory;
  const Trajectory* truth = nullptr;
};

/// The page on an adjustment of a drive and a model of strips: what came out and its test, plan, standard deviations
/// and corrections along the drive, distances of the matched points and their normality, matches by what became of
/// them, the strips that moved most, convergence, parameters, times.
std::string adjustment_html(const JointAdjustment& adjustment, const AdjustedInputs& inputs,
                            std::string_view notes_json, const AdjustmentReportSettings& settings,
                            Task& task);

}  // namespace jalon
