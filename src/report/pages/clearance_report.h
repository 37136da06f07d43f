// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/params.h"
#include "base/task.h"
#include "cloud/cloud.h"
#include "model/model.h"
#include "report/settings.h"

namespace jalon {

/// Operation "clearance_report".
struct ClearanceReportSettings {
  double margin_m = 0.1;  ///< of the sweep: the dashed line and the colours
  double apart_m = 1;     ///< one place stands for what is nearer to it
  int64_t sections = 6;   ///< at the tightest places
  int64_t viewer_points = kViewerPoints;
};
std::span<const ParamRow> clearance_report_rows();

/// What a gauge met on its way, as jalon_gauge_sweep tells it.
struct GaugeRun {
  FieldTable places, intervals;
  std::vector<std::vector<Vec3>>
      gauge;  ///< of each piece points whose hull it is, in the gauge's frame; may be empty
  std::vector<Transform> poses;  ///< at least one
  CloudPtr cloud;                ///< may be nullptr
  ModelPtr model;                ///< may be nullptr
};

constexpr double kDrawnChord_m = 0.001;  ///< arcs of models are drawn as chords this close to them

/// The page on it: least clearance, the clearance along the way, the tight places with their sections, the view.
std::string clearance_html(const GaugeRun& run, std::string_view notes_json,
                           const ClearanceReportSettings& settings, Task& task);

}  // namespace jalon
