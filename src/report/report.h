// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "base/params.h"
#include "base/task.h"
#include "model/model.h"
#include "report/settings.h"
#include "segment/segmentation.h"

namespace jalon {

std::span<const ParamRow> elevation_rows();
std::span<const ParamRow> report_rows();

/// The drawing as SVG text, to scale, axes in metres, scale bar. outlines_only: what the HTML page embeds.
std::string elevation_svg(const Segmentation& segmentation, const Model& model,
                          const ElevationSettings& settings, Task& task);
std::string report_html(const Segmentation& segmentation, const Model& model,
                        std::string_view notes_json, const ReportSettings& settings, Task& task);
std::string report_json(const Segmentation& segmentation, const Model& model,
                        std::string_view notes_json, Task& task);

}  // namespace jalon
