// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "base/params.h"
#include "base/task.h"
#include "registration/registration.h"
#include "report/settings.h"

namespace jalon {

/// Operation "registration_report".
struct RegistrationReportSettings {
  int64_t bins = 60;
  int64_t sample = 100000;  ///< most points of the moving cloud in the histograms
  int64_t viewer_points = kViewerPoints;
};
std::span<const ParamRow> registration_report_rows();

/// The page on a registration: what came out and why it stopped, pose and what it is worth, weak directions, residuals
/// of targets, distances before and after (with both clouds), convergence, parameters, times.
std::string registration_html(const Registration& registration, const CloudPtr& reference,
                              const CloudPtr& moving, std::string_view notes_json,
                              const RegistrationReportSettings& settings, Task& task);

}  // namespace jalon
