// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "base/task.h"
#include "model/model.h"
#include "report/settings.h"
#include "segment/segmentation.h"

namespace jalon {

/// The page on a segmentation by codes: plan, classes, objects, warnings, the view in three dimensions, times.
std::string coded_report_html(const Segmentation& segmentation, const Model& model,
                              std::string_view notes_json, const ReportSettings& settings,
                              Task& task);

}  // namespace jalon
