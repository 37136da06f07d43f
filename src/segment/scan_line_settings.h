// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "segment/segmentation.h"
#include "segment/surface_settings.h"

namespace jalon {

/// The parameters of method "scan_lines"; the rows stand in scan_lines.cpp.
struct ScanLineSettings {
  SurfaceSettings surface;
  double line_tolerance_m = 0;  ///< of a straight piece; 0 = distance_tolerance_m
  double gap_m = 0;          ///< where a line breaks off; 0 = five times the median step of its row
  uint32_t line_points = 4;  ///< fewest of a straight piece
};

/// Parameter table of method "scan_lines".
std::span<const ParamRow> scan_line_rows();
/// Planes from the straight pieces of a scan's rows (see scan_lines.cpp for the steps).
Segmentation segment_by_scan_lines(const CloudPtr& cloud, const ScanLineSettings& settings,
                                   Task& task);

}  // namespace jalon
