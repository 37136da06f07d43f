// SPDX-FileCopyrightText: 2026 The Jalon authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>
#include <vector>

#include "segment/segmentation.h"

namespace jalon {

/// The parameters of operation "labels".
struct LabelSettings {
  std::vector<double> noise_labels{0};  ///< values that mean no segment
  double pixel_m = 0;                   ///< 0 = so that a pixel holds four points on average
  double orientation_tolerance_rad = 0.0174533;
  bool facade_frame = true;
};
std::span<const ParamRow> labels_rows();

/// The segmentation that a field of whole numbers tells: hand labels, true faces of the virtual scanner, another
/// program's result. Each value but the noise labels is a segment, with the least-squares plane of all its points;
/// segments whose points give no plane (fewer than 3, equal, collinear) keep their row, with NaN in it. Rows are
/// numbered anew by falling number of points, ties by value.
Segmentation segmentation_from_labels(const CloudPtr& cloud, std::string_view field,
                                      const LabelSettings& settings, Task& task);

}  // namespace jalon
