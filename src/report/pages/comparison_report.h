// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "base/params.h"
#include "base/task.h"
#include "compare/comparison.h"
#include "report/settings.h"

namespace jalon {

/// Operation "comparison_report".
struct ComparisonReportSettings {
  int64_t bins = 80;
  double threshold_m = 0;  ///< marked in the histograms; 0 = none
  double limit_m = 0;      ///< of the colour scale; 0 = 98 % lie within
  bool picture = true;
  int64_t viewer_points = kViewerPoints;
};
std::span<const ParamRow> comparison_report_rows();

/// Self-contained page on a comparison: pictures of both directions side by side on one colour scale, histogram with
/// the noise law and the threshold, the changes, levels of detection, sampling error, parameters. reverse may be null;
/// changes: a table of regions or of changes, may be empty.
std::string comparison_html(const Comparison& forward, const Comparison* reverse,
                            const FieldTable& changes, std::string_view notes_json,
                            const ComparisonReportSettings& settings, Task& task);
/// The histogram alone, as SVG.
std::string comparison_histogram(const Comparison& comparison,
                                 const ComparisonReportSettings& settings, Task& task);

}  // namespace jalon
